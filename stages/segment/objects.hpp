#pragma once

#include <string>
#include <vector>

#include "core/motion/scene.hpp"

namespace morphe::segment {

/// An interval in which a recorded object moves.
struct ObjectMotion {
  std::string object;  ///< its name
  double begin_s = 0, end_s = 0;
  double displacement_m = 0;  ///< distance between the positions at begin_s − 0.2 s and end_s
};

/// Returns the motions of the recorded objects in order of time. A motion begins when the object
/// has travelled farther than `limit_m` within 0.2 s, and ends when it no longer does; pauses
/// shorter than 0.2 s do not end it. A motion of less than 0.2 s with a displacement below
/// `limit_m` is ignored, since a hand that closes nudges an object.
std::vector<ObjectMotion> object_motions(const std::vector<SceneObject>& objects, double limit_m);

}  // namespace morphe::segment
