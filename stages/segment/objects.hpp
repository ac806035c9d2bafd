#pragma once

#include <string>
#include <vector>

#include "core/motion/scene.hpp"

namespace morphe::segment {

/// An interval in which a recorded object is on its way.
struct ObjectMotion {
  std::string object;
  double begin_s = 0, end_s = 0;
  double way = 0;  ///< from where it was to where it went [m]
};

/// Motions of the recorded objects in order of time. An object moves while it goes farther than
/// `least_m` within 0.2 s; pauses shorter than that do not end a motion, and one that ends where it
/// began, within `least_m`, in less than 0.2 s is none (a hand that closes nudges an object).
std::vector<ObjectMotion> object_motions(const std::vector<SceneObject>& objects, double least_m);

}  // namespace morphe::segment
