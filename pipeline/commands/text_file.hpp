#pragma once

#include <filesystem>
#include <string>

namespace morphe::commands {

/// Writes a text file. Throws InputError if it cannot be written.
void write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace morphe::commands
