#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace morphe::imports {

/// The number format of a C3D file.
enum class C3dProcessor : std::uint8_t { intel = 84, dec = 85, sgi = 86 };

/// The bytes of a C3D file. Every access is checked and throws InputError "FILE: byte N: …" on
/// failure.
struct C3dBytes {
  std::string file;                              ///< file name for messages
  std::string bytes;                             ///< the whole content
  C3dProcessor processor = C3dProcessor::intel;  ///< number format

  /// Returns the number of bytes.
  std::size_t size() const { return bytes.size(); }
  /// Fails unless `count` bytes, which `what` needs, exist at `offset`.
  void require(std::size_t offset, std::size_t count, std::string_view what) const;
  /// Returns a byte.
  std::uint8_t byte(std::size_t offset) const;
  /// Returns `count` characters.
  std::string text(std::size_t offset, std::size_t count) const;
  /// Returns an unsigned number of two bytes.
  std::uint16_t word(std::size_t offset) const;
  /// Returns a signed number of two bytes.
  std::int16_t integer(std::size_t offset) const;
  /// Returns a floating-point number of four bytes.
  float real(std::size_t offset) const;
  /// Throws InputError "FILE: byte N: …".
  [[noreturn]] void fail(std::size_t offset, std::string_view message) const;
};

}  // namespace morphe::imports
