#pragma once

#include <vector>

#include "core/robot/robot.hpp"
#include "pipeline/place/base_placement.hpp"
#include "pipeline/place/trial_movements.hpp"

namespace morphe::place {

/// The region in which a robot's tips can be. Its cells have two coordinates: the distance from the
/// robot's shoulder and the angle to the z axis of its base. The region consists of the cells in
/// which a tip was in some random posture, and their neighbours. A point outside is out of reach as
/// far as these postures show; a point inside may be out of reach as well.
class ReachabilityGrid {
 public:
  /// Computes the region from kPostureCount random postures.
  ReachabilityGrid(const robot::Robot& robot, std::uint64_t seed);
  /// Returns the share [0, 1] of a trial's tip goals outside the region; 0 without goals.
  double share_out_of_reach(const TrialMovement& trial, const BasePlacement& pose) const;
  /// Returns the robot's shoulder in the base frame [m].
  const Vec3& shoulder() const { return shoulder_; }

 private:
  bool is_reachable(std::ptrdiff_t tip, const Vec3& from_shoulder) const;
  std::ptrdiff_t cell_index(std::ptrdiff_t tip, int distance, int angle) const;

  std::ptrdiff_t tips_;
  Vec3 shoulder_;
  double cell_size_m_ = 1;
  std::vector<char> reachable_cells_;  ///< [tips, distances, angles]
};

/// Returns true if a pose is allowed. In every trial, the origin of the base must
///   - be at least kTableClearance_m above the table's top if it is within the table's outline
///   - keep `person_clearance_m` from the vertical line through the person, which is
///     kHalfShoulderBreadth_m to the left of a right shoulder, or to the right of a left one
/// `shoulder` is that of the robot in the base frame, and `side` that of its arm.
bool is_base_allowed(const std::vector<TrialMovement>& trials, const BasePlacement& pose,
                     const Vec3& shoulder, Side side, const PlaceOptions& options);

/// Returns the base's origin relative to the human shoulder, in world axes [m], for this
/// `shoulder`.
Vec3 base_from_human_shoulder(const BasePlacement& pose, const Vec3& shoulder);

}  // namespace morphe::place
