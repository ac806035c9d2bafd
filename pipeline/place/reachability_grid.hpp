#pragma once

#include <vector>

#include "core/robot/robot.hpp"
#include "pipeline/place/base_placement.hpp"
#include "pipeline/place/trial_movements.hpp"

namespace morphe::place {

/// The region that a robot's tips reach, in coordinates about the z axis of its base: the cells of
/// distance from its shoulder and angle to z that random postures reach, and their neighbours. A
/// point outside is out of reach (as far as the samples show); a point inside is not necessarily in
/// reach.
class ReachabilityGrid {
 public:
  /// Samples random postures of the robot.
  ReachabilityGrid(const robot::Robot& robot, std::uint64_t seed);
  /// Returns the share [0, 1] of a trial's tip goals outside the region.
  double share_out_of_reach(const TrialMovement& trial, const BasePlacement& stand) const;
  const Vec3& shoulder() const { return shoulder_; }  ///< in the base frame [m]

 private:
  static constexpr int kDistanceCells = 40, kAngleCells = 18;
  bool is_reachable(std::size_t tip, const Vec3& from_shoulder) const;
  std::size_t cell(std::size_t tip, int distance, int angle) const;

  std::size_t tips_;
  Vec3 shoulder_;
  double cell_size_m_ = 1;
  /// The reachable cells [tips, distances, angles].
  std::vector<char> reachable_cells_;
};

/// Returns true if the placement of the base is allowed: in every trial, the origin of its frame
///   - is not below the table's top (nor less than 5 mm above it) within the outline of the table,
///   - keeps `person_clearance_m` from the vertical line through the person's middle, 0.2 m to the
///     left of the right shoulder (to the right of the left one), which is about half a man's
///     shoulder breadth.
bool is_base_allowed(const std::vector<TrialMovement>& trials, const BasePlacement& stand,
                     const Vec3& shoulder, Side side, const PlaceOptions& options);

/// Returns the origin of the base relative to the human shoulder, in world axes [m].
Vec3 base_from_human_shoulder(const BasePlacement& stand, const Vec3& shoulder);

}  // namespace morphe::place
