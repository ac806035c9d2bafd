#include "pipeline/commands/text_file.hpp"

#include "core/files/atomic_file.hpp"

namespace morphe::commands {

void write_text(const std::filesystem::path& file, const std::string& text) {
  files::write_atomically(file, text);
}

}  // namespace morphe::commands
