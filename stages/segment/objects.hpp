#pragma once

#include <string>
#include <vector>

#include "core/motion/scene.hpp"

namespace morphe::segment {

/// An interval in which a recorded object moves.
struct ObjectMotion {
  /// Name of the object.
  std::string object;
  /// Start and end of the motion.
  double begin_s = 0, end_s = 0;
  double displacement_m = 0;  ///< distance between the positions at start and end [m]
};

/// Returns the motions of the recorded objects in order of time. An object moves while it travels
/// farther than `least_m` within 0.2 s; pauses shorter than that do not end a motion. A motion that
/// ends within `least_m` of its start in less than 0.2 s is ignored (a hand that closes nudges an
/// object).
std::vector<ObjectMotion> object_motions(const std::vector<SceneObject>& objects, double least_m);

}  // namespace morphe::segment
