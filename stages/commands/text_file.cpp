#include "stages/commands/text_file.hpp"

#include <fmt/format.h>

#include <fstream>

#include "pipeline/motion/input_error.hpp"

namespace morphe::commands {

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  if (!stream.flush()) throw InputError(fmt::format("{}: cannot be written", file.string()));
}

}  // namespace morphe::commands
