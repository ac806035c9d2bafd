#pragma once

#include <vector>

#include "core/motion/robot_model.hpp"

namespace morphe::robot {

/// The axes of the hinges from the base to the palm, at one posture, in the base frame.
struct ArmAxes {
  std::vector<Vec3> direction;  ///< [hinges] unit vectors
  std::vector<Vec3> point;      ///< [hinges] a point of each axis [m]
  Vec3 palm = Vec3::Zero();     ///< origin of the palm's frame [m]

  /// Returns the number of hinges.
  int count() const { return static_cast<int>(direction.size()); }
};

/// Returns the frames of the hinges that move the palm, from the base on.
std::vector<int> arm_hinges(const RobotModel& robot);

/// Returns the axes of these hinges.
ArmAxes arm_axes(const RobotModel& robot, const std::vector<int>& hinges,
                 const std::vector<Pose>& base_from_frame);

/// Returns true if the angle between two axes is at least a degree.
bool are_inclined(const ArmAxes& axes, int hinge, int other);

/// Returns a_{m-1} · (a_m × a_{m+1}) / (|a_{m-1} × a_m| |a_m × a_{m+1}|) of three consecutive axes:
/// the sine of the middle hinge from the position at which the three are parallel to one plane. NaN
/// if there are no such axes, or if the middle one is parallel to a neighbour.
double triple_product(const ArmAxes& axes, int middle);

/// Returns the point of an axis nearest to that of `neighbour` or, if this is parallel or absent,
/// of `other`; the point nearest to the palm if the axis is the last one [m].
Vec3 foot_point(const ArmAxes& axes, int hinge, int neighbour, int other);

/// Returns the part of (point - axis) at right angles to the axis [m].
Vec3 lever_from_axis(const ArmAxes& axes, int hinge, const Vec3& point);

}  // namespace morphe::robot
