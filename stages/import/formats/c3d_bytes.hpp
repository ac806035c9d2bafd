#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace morphe::imports {

/// What the numbers of a C3D file look like.
enum class C3dProcessor : std::uint8_t { intel = 84, dec = 85, sgi = 86 };

/// The bytes of a C3D file; every access is checked. InputError "FILE: byte N: …".
struct C3dBytes {
  std::string file;   ///< for messages
  std::string bytes;  ///< its whole content
  C3dProcessor processor = C3dProcessor::intel;

  std::size_t size() const { return bytes.size(); }
  /// Fails unless `count` bytes stand at `offset`; `what` needed them.
  void require(std::size_t offset, std::size_t count, std::string_view what) const;
  std::uint8_t byte(std::size_t offset) const;
  std::string text(std::size_t offset, std::size_t count) const;
  std::uint16_t word(std::size_t offset) const;
  std::int16_t integer(std::size_t offset) const;
  float real(std::size_t offset) const;
  [[noreturn]] void fail(std::size_t offset, std::string_view message) const;
};

}  // namespace morphe::imports
