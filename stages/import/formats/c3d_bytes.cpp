#include "stages/import/formats/c3d_bytes.hpp"

#include <fmt/format.h>

#include <bit>

#include "core/motion/input_error.hpp"

namespace morphe::imports {

void C3dBytes::fail(std::size_t offset, std::string_view message) const {
  throw InputError(fmt::format("{}: byte {}: {}", file, offset, message));
}

void C3dBytes::require(std::size_t offset, std::size_t count, std::string_view part) const {
  if (offset <= bytes.size() && count <= bytes.size() - offset) return;
  fail(offset,
       fmt::format("{} needs {} bytes, but the file ends at byte {}", part, count, bytes.size()));
}

std::uint8_t C3dBytes::byte(std::size_t offset) const {
  require(offset, 1, "a number");
  return static_cast<std::uint8_t>(bytes[offset]);
}

std::string C3dBytes::text(std::size_t offset, std::size_t count) const {
  require(offset, count, "a text");
  return bytes.substr(offset, count);
}

std::uint16_t C3dBytes::word(std::size_t offset) const {
  const std::uint32_t first = byte(offset), second = byte(offset + 1);
  return static_cast<std::uint16_t>(processor == C3dProcessor::sgi ? first << 8 | second
                                                                   : second << 8 | first);
}

std::int16_t C3dBytes::integer(std::size_t offset) const {
  return static_cast<std::int16_t>(word(offset));
}

float C3dBytes::real(std::size_t offset) const {
  const std::uint32_t first = word(offset), second = word(offset + 2);
  if (processor == C3dProcessor::intel) return std::bit_cast<float>(second << 16 | first);
  const float value = std::bit_cast<float>(first << 16 | second);
  // DEC's exponents have the bias 128, not 127, and its mantissas the range [0.5, 1), not [1, 2).
  return processor == C3dProcessor::dec ? value / 4 : value;
}

}  // namespace morphe::imports
