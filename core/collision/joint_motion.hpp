#pragma once

#include <functional>

#include "core/collision/distance.hpp"

namespace morphe::collision {

/// A motion over a parameter s. `position` and `travel` resize the vector that they fill.
struct JointMotion {
  double begin = 0, end = 1;  ///< range of s
  std::function<void(double s, JointVector& q)> position;
  /// Bounds each joint's distance, within [s0, s1], from its position at (s0 + s1) / 2.
  std::function<void(double s0, double s1, JointVector& travel)> travel;
  std::function<double(double s)> demonstration_time;  ///< non-decreasing [s]
};

/// Returns the straight line between two joint positions, with s in [0, 1] and the demonstration
/// time going from from_s to to_s.
JointMotion straight_motion(const JointVector& from, const JointVector& to, double from_s,
                            double to_s);

/// Returns a bound on the distance of any point of an object within [begin_s, end_s] from its place
/// at `middle_s`, all demonstration times [m]: path length of the centre + bounding radius * angle
/// of rotation, before or after middle_s, whichever is larger.
double object_travel(const Solid& solid, double begin_s, double middle_s, double end_s);

}  // namespace morphe::collision
