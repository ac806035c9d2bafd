#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/motion/enum_names.hpp"

namespace morphe {

/// The side of the body to which the reaching hand belongs.
enum class Side : std::uint8_t { right, left };
/// Returns the names of the values, in their order.
constexpr std::array<std::string_view, 2> names_of(Side) { return {"right", "left"}; }

}  // namespace morphe
