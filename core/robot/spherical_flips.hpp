#pragma once

#include <vector>

#include "core/motion/robot_model.hpp"

namespace morphe::robot {

/// Three consecutive joints whose axes are orthogonal in turn, as in a shoulder or a wrist: the
/// middle one is orthogonal to both others and can make them parallel. If the axes also meet in one
/// point, two sets of positions move all later links alike:
///   (q_first, q_middle, q_last) ~ (q_first + π, 2 parallel - q_middle, q_last + π).
/// With the rounded angles of a description this holds within a millimetre or two.
struct SphericalFlip {
  int first, middle, last;  ///< joints
  double parallel_rad;      ///< position of the middle joint at which the outer axes are parallel
};

/// Returns a flip for all three consecutive hinges with the middle one orthogonal to both others,
/// in the order of the frames. It is not tested that the axes meet in one point.
std::vector<SphericalFlip> possible_flips(const RobotModel& robot);

/// Returns the posture with the flip applied, regardless of the limits.
JointVector apply_flip(const SphericalFlip& flip, JointVector q);

}  // namespace morphe::robot
