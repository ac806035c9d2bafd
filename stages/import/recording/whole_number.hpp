#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

namespace morphe::imports {

/// Returns the integer in a cell, if it has one: nanoseconds since 1970 are inexact as doubles.
inline std::optional<std::int64_t> whole_number(std::string_view cell) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size()) return std::nullopt;
  return value;
}

}  // namespace morphe::imports
