#pragma once

#include "core/motion/side.hpp"
#include "stages/import/guess/recorded_points.hpp"

namespace morphe::imports {

/// How an arm is held in a world whose Z axis points up: medians over the frames, NaN if the points
/// that they need were not recorded.
struct ArmBearing {
  /// Angle between Z and the direction from the elbow to the shoulder [rad].
  double upper_arm_rad = 0;
  /// Displacement of the thumb's tip from the index tip to the inner side of the hand, which is the
  /// left one of a right hand, seen from above and along the line from the wrist to both [m].
  double thumb_inside_m = 0;
  /// Displacement of the elbow to the outer side of the vertical plane through shoulder and wrist.
  double elbow_outside_m = 0;
};
ArmBearing arm_bearing(const RecordedPoints& points, Side side);

}  // namespace morphe::imports
