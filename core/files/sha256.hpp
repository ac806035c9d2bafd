#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace morphe::files {

/// SHA-256 in lower-case hexadecimal.
std::string sha256(std::string_view bytes);
/// The 32 bytes themselves.
std::string sha256_bytes(std::string_view bytes);
/// Of a file's bytes, read in blocks; InputError if it cannot be read.
std::string sha256_of_file(const std::filesystem::path& file);

}  // namespace morphe::files
