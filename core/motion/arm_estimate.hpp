#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "core/motion/plan.hpp"

namespace morphe {

/// Names of the arm points that HumanMotion::estimated and Goals::estimated may contain.
inline constexpr std::array<std::string_view, 2> kArmPointNames = {"shoulder", "elbow"};

/// Returns true if the person's shoulder or elbow was not recorded. Humanlikeness A and the angle
/// of the upper arm then refer to an estimate, and are marked by a ~ wherever they are printed.
inline bool is_arm_estimated(const Goals& goals) {
  return std::ranges::any_of(goals.estimated, [](const std::string& point_name) {
    return std::ranges::find(kArmPointNames, point_name) != kArmPointNames.end();
  });
}

}  // namespace morphe
