#pragma once

#include <functional>

#include "core/collision/joint_motion.hpp"
#include "core/collision/world.hpp"

namespace morphe::collision {

/// The pairs of a world over a motion, for bisection. for_each_part() comes first: in each part of
/// the motion, the allowed contacts and the target's attachment are constant.
struct MotionPairs {
  const CollisionWorld& world;
  const JointMotion& motion;
  CollisionScratch& scratch;

  double part_s = kUnknown;  ///< demonstration time in the middle of the current part
  TargetState target_state = TargetState::as_recorded;  ///< state in the current part
  JointRows cluster_levers = {};  ///< [clusters, n] the largest motion bounds of their capsules

  /// Calls part(from, to) for each part of the motion, until it returns false.
  void for_each_part(const std::function<bool(double from, double to)>& part);

  /// Returns a pair with its required distance in the current part, without its separation.
  PairSeparation unmeasured(const BodyPair& bodies) const;
  /// Returns true if the pair may touch in the current part.
  bool may_touch(const BodyPair& pair) const;

  /// Computes all bodies at `middle` = (s0 + s1) / 2, and bounds on their travel within [s0, s1].
  void set_interval(double s0, double middle, double s1);
  /// Tells of a lower bound of slacks at the interval's middle and an upper bound of travels [m]
  /// that pairs within them need not be looked at.
  using Excludes = std::function<bool(double slack_m, double travel_m)>;
  /// Fills scratch.undecided_pairs[0] with the pairs in the order of near_pairs(), but for those
  /// that are excluded with the whole clusters of their capsules.
  void list_pairs(const Excludes& excludes);
  /// Returns a bound on the distance that the pair can lose within the current interval [m].
  double pair_travel(const BodyPair& pair) const;
  /// Returns a lower bound of the pair's slack at the interval's middle, from bounding spheres [m].
  double slack_lower_bound(const PairSeparation& pair) const;

 private:
  void find_near_clusters(const Excludes& excludes);
  double relative_travel(int a, const double* levers_a, int b, const double* levers_b) const;
  double parameter_at_time(double time_s) const;
};

}  // namespace morphe::collision
