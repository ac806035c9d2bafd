#pragma once

#include <functional>

#include "core/collision/continuous_check.hpp"

namespace morphe::collision {

/// Maximum depth of bisection. The interval is then 1e-12 of the motion, so its travel does not
/// shrink or cannot shrink further.
inline constexpr std::size_t kMaxBisectionDepth = 40;

/// The pairs of a world over a motion, for use in bisection. They are numbered: first those of
/// world.pairs, then the objects of each capsule in turn.
struct MotionPairs {
  const CollisionWorld& world;
  const JointMotion& motion;
  CollisionScratch& scratch;

  bool contact_allowed = false;  ///< true if contact is allowed in the current part of the motion
  TargetState target_state = TargetState::as_recorded;  ///< state in the current part

  /// Calls part(from, to), with all pairs in scratch.undecided_pairs[0], for the parts of the
  /// motion in which allowed contact and the attachment of the target do not change, until it
  /// returns false.
  void for_each_part(const std::function<bool(double from, double to)>& part);

  /// Returns the number of objects of the scene.
  std::size_t objects() const { return world.scene->objects.size(); }
  /// Returns the pair with a number, without its separation.
  PairSeparation pair_of(std::size_t number) const;
  /// Returns true if the pair may touch in the current part.
  bool may_touch(const PairSeparation& pair) const;

  /// Computes all bodies at `middle`, and bounds on their distance from there within [s0, s1].
  void set_interval(double s0, double middle, double s1);
  /// Returns a bound on the distance that the pair can lose within the current interval [m].
  double pair_travel(const PairSeparation& pair) const;
  /// Returns a lower bound of the pair's slack at little cost.
  double slack_lower_bound(const PairSeparation& pair) const;
  /// Computes the pair's separation.
  void measure(PairSeparation& pair) const;

 private:
  double relative_travel(int a, const double* levers_a, int b, const double* levers_b) const;
  double parameter_at_time(double time_s) const;
};

}  // namespace morphe::collision
