#pragma once

#include <functional>
#include <optional>

#include "core/motion/robot_model.hpp"

namespace morphe::setup {

/// A capsule of a hand that overlaps one of the arm.
struct MountCollision {
  int hand_capsule = -1, arm_capsule = -1;
  double depth_m = 0;
  /// True if the axis of the thinner capsule is more than kMaxMountDepth_m inside the other.
  bool stands_inside = false;
};

/// An overlap is reported from this depth on [m]: chosen by hand, about as much as capsules stand
/// off the surface (95 % of it within 12 mm).
inline constexpr double kMaxMountDepth_m = 0.01;

/// Finds the worst overlap of a hand with links of the arm other than the one that carries it, of
/// those in at least 95 % of 100 postures of the joints between, from a fixed seed; the hand is at
/// rest. `of_arm` tells whether a capsule is one of the arm. Returns nullopt if none is deeper than
/// kMaxMountDepth_m.
std::optional<MountCollision> find_mount_collision(const RobotModel& robot, int flange_frame,
                                                   const std::function<bool(int)>& of_arm);

}  // namespace morphe::setup
