#pragma once

#include <functional>

#include "core/collision/world.hpp"

namespace morphe::collision {

/// A motion over a parameter s: the joint positions at s, and for each joint a bound on its
/// distance within [s0, s1] from its position at (s0 + s1) / 2. Both functions set the size of the
/// vector that they fill.
struct JointMotion {
  double begin = 0, end = 1;
  std::function<void(double s, JointVector& q)> position;
  std::function<void(double s0, double s1, JointVector& travel)> travel;
  std::function<double(double s)> demonstration_time;  ///< non-decreasing
};

/// Returns the straight line between two joint positions, s in [0, 1].
JointMotion straight_motion(const JointVector& from, const JointVector& to, double from_s,
                            double to_s);

/// The result of a continuous collision check.
enum class MotionVerdict { free, colliding, undecided };

/// The result of check_motion(). A motion is free if slack >= 0 everywhere: proved by bisection
/// until the slack at the middle of each interval exceeds the distance that any pair can lose
/// within it. Cases that intervals with a travel below `band_m` cannot decide are undecided and
/// count as not free. If contact becomes allowed or forbidden within the motion, the motion is
/// split at these times.
struct MotionCheck {
  MotionVerdict verdict = MotionVerdict::free;
  double parameter = 0;       ///< parameter of the failure, or of the smallest slack found
  PairSeparation pair;        ///< the pair with this slack
  double begin = 0, end = 0;  ///< failing_pairs(): interval in which the pair is not proved free
};
/// Checks a motion for collisions, continuously.
MotionCheck check_motion(const CollisionWorld& world, const JointMotion& motion,
                         CollisionScratch& scratch, double band_m = 1e-4);

/// Checks each pair separately. `out` gets one entry for every pair and every interval in which it
/// is not proved free (within the band), in the order of pairs, then of time. `parameter` is the
/// position of the smallest slack found; the verdict is undecided if this slack was above 0. `out`
/// is empty if the motion is free.
void failing_pairs(const CollisionWorld& world, const JointMotion& motion,
                   CollisionScratch& scratch, std::vector<MotionCheck>& out, double band_m = 1e-4);

/// The minimum distance over the whole motion of pairs that may not touch: it was found at
/// `parameter`, and the distance is nowhere below lower_bound_m >= distance - resolution. It is
/// +infinity if there is no such pair.
struct MotionClearance {
  double lower_bound_m = 0, distance = 0, parameter = 0;  ///< [m], [m], parameter
  PairSeparation pair;
};
/// Computes the minimum clearance of a motion.
MotionClearance motion_clearance(const CollisionWorld& world, const JointMotion& motion,
                                 CollisionScratch& scratch, double resolution_m = 1e-4);

/// Returns a bound on the distance of any point of an object within [begin_s, end_s] from its
/// position at `middle_s` (demonstration time): the length of its path plus its radius times the
/// angle of rotation along it [m].
double object_travel(const Solid& solid, double begin_s, double middle_s, double end_s);

}  // namespace morphe::collision
