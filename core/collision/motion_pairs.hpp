#pragma once

#include <functional>

#include "core/collision/certified.hpp"

namespace morphe::collision {

/// Deeper than this an interval is 1e-12 of the motion: its travel does not shrink, or cannot.
inline constexpr std::size_t kDeepestBisection = 40;

/// The pairs of a world over a motion, as its bisections see them. They are numbered: those of
/// world.pairs first, then capsule by capsule its objects.
struct MotionPairs {
  const CollisionWorld& world;
  const JointMotion& motion;
  CollisionScratch& scratch;

  bool touching = false;  ///< whether the part of the motion at hand may touch
  TargetPlace target_place = TargetPlace::as_recorded;  ///< in that part

  /// Calls part(from, to), with all pairs in scratch.open[0], for the parts of the motion in which
  /// what may touch, and where the target is held, does not change, until it says to stop.
  void run(const std::function<bool(double from, double to)>& part);

  std::size_t objects() const { return world.scene->objects.size(); }
  PairSeparation pair_of(std::size_t number) const;
  /// Whether the pair may touch now.
  bool touches(const PairSeparation& pair) const;

  /// All bodies at `middle`, and how far each gets from there within [s0, s1].
  void place(double s0, double middle, double s1);
  /// How much nearer the pair can come within the interval placed last [m].
  double travel_of(const PairSeparation& pair) const;
  /// No more than the pair's slack, at little cost.
  double slack_at_least(const PairSeparation& pair) const;
  /// Fills in its separation.
  void measure(PairSeparation& pair) const;

 private:
  double travel_between(int a, const double* levers_a, int b, const double* levers_b) const;
  double passing(double time_s) const;
};

}  // namespace morphe::collision
