#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace morphe::files {

/// Returns the SHA-256 in lower-case hexadecimal.
std::string sha256(std::string_view bytes);
/// Returns the 32 bytes of the SHA-256.
std::string sha256_bytes(std::string_view bytes);
/// Returns the SHA-256 of a file, read in blocks; throws InputError if it cannot be read.
std::string sha256_of_file(const std::filesystem::path& file);

}  // namespace morphe::files
