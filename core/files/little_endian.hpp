#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace morphe::files {

/// Reads `count` <= 8 of the bytes, the first at index `at`, as an integer, lowest byte first.
inline std::uint64_t read_little_endian(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint64_t value = 0;
  for (; count > 0; --count) value = value << 8 | static_cast<unsigned char>(bytes[at + count - 1]);
  return value;
}

/// Appends the lowest `count` bytes of an integer, lowest byte first.
inline void append_little_endian(std::uint64_t value, std::size_t count, std::string& bytes) {
  for (; count > 0; --count, value >>= 8) bytes += static_cast<char>(value & 0xFF);
}

}  // namespace morphe::files
