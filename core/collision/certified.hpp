#pragma once

#include <functional>

#include "core/collision/world.hpp"

namespace morphe::collision {

/// A motion over a parameter s: where the joints are at s, and for each joint a bound on how far it
/// gets from its position at (s0 + s1) / 2 anywhere within [s0, s1]. Both set the
/// size of the vector they fill.
struct JointMotion {
  double begin = 0, end = 1;
  std::function<void(double s, JointVector& q)> position;
  std::function<void(double s0, double s1, JointVector& travel)> travel;
  std::function<double(double s)> demonstration_time;  ///< not decreasing
};

/// The straight line between two joint positions, s in [0, 1].
JointMotion straight_motion(const JointVector& from, const JointVector& to, double from_s,
                            double to_s);

enum class MotionVerdict { free, colliding, undecided };

/// Free means slack >= 0 all along: proved by bisection until the slack at the middle of each
/// interval exceeds what any pair can close within it. What cannot be decided with intervals whose
/// travel is below `band_m` is undecided and counts as not free. Where touching begins or ends
/// within the motion it is cut there.
struct MotionCheck {
  MotionVerdict verdict = MotionVerdict::free;
  double at = 0;              ///< parameter of the failure, or of the least slack seen
  PairSeparation pair;        ///< the pair there
  double begin = 0, end = 0;  ///< of failing_pairs(): where the pair is not proved free
};
MotionCheck check_motion(const CollisionWorld& world, const JointMotion& motion,
                         CollisionScratch& scratch, double band_m = 1e-4);

/// The same for each pair by itself: one entry for every pair and every interval in which it is not
/// proved free (to within the band), in the order of pairs, then of time; `at` is where the least
/// slack was seen, the verdict undecided if that was above 0. Empty = free.
void failing_pairs(const CollisionWorld& world, const JointMotion& motion,
                   CollisionScratch& scratch, std::vector<MotionCheck>& out, double band_m = 1e-4);

/// Least distance over the whole motion of pairs that may not touch, where and which: seen at `at`,
/// and nowhere less than at_least >= distance - resolution. +infinity if there is no such pair.
struct MotionClearance {
  double at_least = 0, distance = 0, at = 0;  ///< [m], [m], parameter
  PairSeparation pair;
};
MotionClearance motion_clearance(const CollisionWorld& world, const JointMotion& motion,
                                 CollisionScratch& scratch, double resolution_m = 1e-4);

/// How far any point of an object gets from where it is at `middle_s` within [begin_s, end_s]
/// (demonstration time): the length of its way plus its radius times the angle turned on it [m].
double object_travel(const Solid& solid, double begin_s, double middle_s, double end_s);

}  // namespace morphe::collision
