#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "core/motion/plan.hpp"

namespace morphe {

/// Of the person's arm, as HumanMotion::estimated and Goals::estimated call them.
inline constexpr std::array<std::string_view, 2> kArmPoints = {"shoulder", "elbow"};

/// Whether the person's shoulder or elbow was not recorded: then humanlikeness A and the angle of
/// the upper arm compare with an estimate, and are marked by a ~ wherever they are printed.
inline bool arm_estimated(const Goals& goals) {
  return std::ranges::any_of(goals.estimated, [](const std::string& what) {
    return std::ranges::find(kArmPoints, what) != kArmPoints.end();
  });
}

}  // namespace morphe
