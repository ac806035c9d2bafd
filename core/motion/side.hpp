#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/motion/named.hpp"

namespace morphe {

/// Of the body: which hand reaches.
enum class Side : std::uint8_t { right, left };
constexpr std::array<std::string_view, 2> names_of(Side) { return {"right", "left"}; }

}  // namespace morphe
