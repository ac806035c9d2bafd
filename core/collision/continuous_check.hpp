#pragma once

#include "core/collision/constants.hpp"
#include "core/collision/joint_motion.hpp"
#include "core/collision/world.hpp"

namespace morphe::collision {

/// The result of a continuous collision check.
enum class MotionVerdict { free, colliding, undecided };

/// The result of check_motion(), or of failing_pairs() for one pair.
struct MotionCheck {
  MotionVerdict verdict = MotionVerdict::free;
  double parameter = 0;       ///< at which `pair` was measured
  PairSeparation pair;        ///< no_pair() if the world has no pairs
  double begin = 0, end = 0;  ///< failing_pairs(): interval in which the pair is not proved free
};
/// Proves by bisection that slack >= 0 for every pair at every parameter of a motion. An interval
/// is free of a pair's collision if the slack at its middle is at least the pair's travel, the
/// distance that the pair can lose within the interval. The pair is undecided if this does not hold
/// when the travel is below `band_m`. The motion is split where contact becomes allowed or
/// forbidden. Returns the first failure found, else the smallest slack measured.
MotionCheck check_motion(const CollisionWorld& world, const JointMotion& motion,
                         CollisionScratch& scratch, double band_m = kMotionBand_m);

/// Checks each pair separately. `out` gets one entry for every pair and every interval in which the
/// pair is not proved free, in the order of near_pairs(), then of the parameter; it is empty if the
/// motion is free. An entry's pair has the smallest slack measured in the interval; its verdict is
/// undecided if this slack is not below 0.
void failing_pairs(const CollisionWorld& world, const JointMotion& motion,
                   CollisionScratch& scratch, std::vector<MotionCheck>& out,
                   double band_m = kMotionBand_m);

/// Returns the kind of a pair.
ClearanceKind kind_of(const CollisionWorld& world, const BodyPair& pair);

/// The minimum distance, over a whole motion, of pairs that may not touch.
struct MotionClearance {
  double lower_bound_m = 0;  ///< no distance is below it
  double distance = 0;       ///< the smallest one measured [m]; +infinity without such pairs
  double parameter = 0;      ///< at which it was measured
  PairSeparation pair;       ///< with this distance
};
/// Computes the minimum clearance of a motion for each ClearanceKind, with
/// lower_bound_m >= distance - resolution_m.
std::array<MotionClearance, kClearanceKindCount> clearance_by_kind(
    const CollisionWorld& world, const JointMotion& motion, CollisionScratch& scratch,
    double resolution_m = kMotionClearanceError_m);

/// Returns the least of clearance_by_kind(): the minimum over all pairs.
MotionClearance motion_clearance(const CollisionWorld& world, const JointMotion& motion,
                                 CollisionScratch& scratch,
                                 double resolution_m = kMotionClearanceError_m);

}  // namespace morphe::collision
