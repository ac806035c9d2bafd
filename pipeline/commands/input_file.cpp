#include "pipeline/commands/input_file.hpp"

#include "core/files/data_files.hpp"

namespace morphe::commands {

CLI::Validator input_file() {
  return {[](std::string& file) {
            file = files::resolve_data_file(file).string();
            return std::string();
          },
          ""};
}

}  // namespace morphe::commands
