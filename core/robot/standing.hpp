#pragma once

#include <string>

#include "core/motion/robot_model.hpp"

namespace morphe::robot {

/// The way a robot stands by itself, as its description tells. The names of the frames tell whether
/// it has a body (legs, a trunk or wheels) below its arm.
struct Standing {
  /// The direction that is up, in the base frame: z by the convention of URDFs, or for a robot with
  /// legs the axis that points from them to the shoulder.
  Vec3 up = Vec3::UnitZ();
  /// The direction to which a robot with a body faces, in the base frame: forward of its frames
  /// that are named left and right, or x by the convention of URDFs. Unknown without a body.
  Vec3 forward = unknown_point();
  std::string evidence;  ///< the first frame that shows that the robot has a body; "" without one

  /// Returns true if the robot has legs, a trunk or wheels, so that it stands upright and faces a
  /// direction.
  bool has_body() const { return !evidence.empty(); }
};

/// Derives how a robot stands, all joints at zero.
Standing standing_of(const RobotModel& robot);

/// Returns how a base with this rotation stands, in words that follow "the base": "stands upright",
/// "hangs, tilted by 8 degrees from straight down", "is on its side, …". A robot with a body is
/// "head down" if it hangs, and the words say where an upright one faces: "stands upright, with its
/// back to the table". The world has X to the person's right, Y forward and Z up.
std::string standing_words(const Standing& standing, const Quat& world_from_base);

}  // namespace morphe::robot
