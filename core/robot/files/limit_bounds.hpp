#pragma once

#include <string_view>

#include "core/motion/key_bounds.hpp"

namespace morphe::robot {

/// Returns the bounds of a joint's limit in a description, by its key: lower, upper, velocity,
/// acceleration or jerk.
constexpr const KeyBounds& limit_bounds(std::string_view key) {
  if (key == "velocity") return bounds::kJointVelocity;
  if (key == "acceleration") return bounds::kJointAcceleration;
  return key == "jerk" ? bounds::kJointJerk : bounds::kJointPosition;
}

}  // namespace morphe::robot
