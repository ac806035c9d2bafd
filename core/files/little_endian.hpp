#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace morphe::files {

/// Reads `count` bytes, at most 8, from `at` on as an unsigned integer, lowest byte first. The
/// bytes must exist.
inline std::uint64_t read_little_endian(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint64_t value = 0;
  for (std::size_t k = count; k > 0; --k) {
    value = value << 8 | static_cast<unsigned char>(bytes[at + k - 1]);
  }
  return value;
}

/// Appends the lowest `count` bytes of an integer, lowest byte first.
inline void append_little_endian(std::uint64_t value, std::size_t count, std::string& bytes) {
  for (; count > 0; --count, value >>= 8) bytes += static_cast<char>(value & 0xFF);
}

}  // namespace morphe::files
