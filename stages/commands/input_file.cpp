#include "stages/commands/input_file.hpp"

#include "pipeline/files/shipped.hpp"

namespace morphe::commands {

CLI::Validator input_file() {
  return {[](std::string& file) {
            file = files::here_or_shipped(file).string();
            return std::string();
          },
          ""};
}

}  // namespace morphe::commands
