#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace morphe::imports {

/// The number format of a C3D file.
enum class C3dProcessor : std::uint8_t { intel = 84, dec = 85, sgi = 86 };

/// The bytes of a C3D file. Access to bytes that do not exist throws InputError "FILE: byte N: …".
struct C3dBytes {
  std::string file;   ///< file name for messages
  std::string bytes;  ///< the whole content
  C3dProcessor processor = C3dProcessor::intel;

  std::size_t size() const { return bytes.size(); }  ///< number of bytes
  /// Fails unless `count` bytes, which `part` of the file needs, exist at `offset`.
  void require(std::size_t offset, std::size_t count, std::string_view part) const;
  std::uint8_t byte(std::size_t offset) const;                    ///< one byte
  std::string text(std::size_t offset, std::size_t count) const;  ///< `count` characters
  std::uint16_t word(std::size_t offset) const;                   ///< two bytes
  std::int16_t integer(std::size_t offset) const;                 ///< two bytes
  float real(std::size_t offset) const;                           ///< four bytes
  /// Throws InputError "FILE: byte N: …".
  [[noreturn]] void fail(std::size_t offset, std::string_view message) const;
};

}  // namespace morphe::imports
