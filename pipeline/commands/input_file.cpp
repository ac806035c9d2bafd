#include "pipeline/commands/input_file.hpp"

#include "core/files/shipped.hpp"

namespace morphe::commands {

CLI::Validator input_file() {
  return {[](std::string& file) {
            file = files::here_or_shipped(file).string();
            return std::string();
          },
          ""};
}

}  // namespace morphe::commands
