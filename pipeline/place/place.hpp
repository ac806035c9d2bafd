#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pipeline/place/score.hpp"

namespace morphe::place {

/// The results of full plans with a placement over all movements.
struct PlannedSummary {
  /// The means over the mapped frames, with these exceptions. out_of_reach: as the plans determine
  /// it; collision_share: share of plans without a trajectory; upper_arm_error: of the trajectory,
  /// if there is one; speed_ratio: tempo of the trajectory.
  PlacementMeasures measures;
  /// The number of movements and of executable plans.
  int movements = 0, executable = 0;
  /// Median and maximum of the movements' means [rad].
  double upper_arm_error_median = 0, upper_arm_error_max = 0;
  /// Maximum over plans with a trajectory [m].
  double tip_error_max_m = kUnknown;
};

/// A placement with its measures.
struct PlacementResult {
  /// The placement as represented in the search.
  BasePlacement base_placement;
  /// The placement in the config, rounded as it was planned.
  map::PlacementOptions placement;
  /// Measures of the search.
  PlacementMeasures search_measures;
  /// The results of full plans.
  PlannedSummary plan_summary;
  /// Origin of the base relative to the human shoulder [m].
  Vec3 base = Vec3::Zero();
  /// Height of the base above the table's top, mean over the movements [m].
  double height_above_table = kUnknown;
};

/// A callback with the current stage and its progress, called from one thread at a time.
using ProgressCallback = std::function<void(const std::string& what, int done, int of)>;

/// Finds placements of the robot's base, each for all movements, the best first:
///   1. `samples` random placements that satisfy the constraints; the `candidates` with the
///      smallest share of goals outside the ReachabilityGrid are kept
///   2. these are mapped in one trial, the better third in three, with few frames (score.hpp)
///   3. the best `refined` distinct ones are improved by a compass search over shift and turn
///      (refine.hpp) over all trials: all with coarse steps, the better half with fine steps
///   4. the best `planned` distinct ones are planned in full and sorted by the result
/// Equal options give equal placements with any number of threads. Throws InputError if no
/// placement is allowed.
std::vector<PlacementResult> find_placements(const planning::PlanningInputs& planner,
                                             const std::vector<TrialMovement>& trials,
                                             const PlaceOptions& options,
                                             const ProgressCallback& report);

/// Computes full plans with one placement.
PlacementResult plan_with_placement(const planning::PlanningInputs& planner,
                                    const std::vector<TrialMovement>& trials,
                                    const map::PlacementOptions& placement, int jobs);

}  // namespace morphe::place
