#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pipeline/place/score.hpp"

namespace morphe::place {

/// The results of full plans over all movements.
struct PlannedSummary {
  /// Means over the mapped movements of the measures of their mapped frames, except:
  ///   out_of_reach     share of goals that the plans find out of reach
  ///   collision_share  share of all movements without a trajectory
  ///   upper_arm_error  that of the trajectory, if there is one
  ///   speed_ratio      the trajectory's duration ratio, if there is one
  /// Those of movements that miss every goal by the most, if no movement was mapped.
  PlacementMeasures measures;
  int movements = 0, executable = 0;
  /// A sentence for each movement that fails before it is mapped, which no placement changes:
  /// "ADL001/000 (no_goal: no fingertip was seen in the grasp)". These count as failed.
  std::vector<std::string> failed_before_mapping;
  double upper_arm_error_median = 0, upper_arm_error_max = 0;  ///< of the movements' means [rad]
  double tip_error_max_m = kUnknown;                           ///< over plans with a trajectory
};

/// A placement with its measures.
struct PlacementResult {
  BasePlacement base_placement;     ///< the same placement as a pose
  map::PlacementOptions placement;  ///< as planned, rounded
  PlacementMeasures search_measures;
  PlannedSummary plan_summary;
  Vec3 base = Vec3::Zero();              ///< origin of the base relative to the human shoulder [m]
  double height_above_table = kUnknown;  ///< of the base, mean over the movements [m]
};

/// A callback with the progress of a stage, called from one thread at a time.
using ProgressCallback = std::function<void(const std::string& stage, int finished, int total)>;

/// Finds placements of the robot's base, each for all movements, the best first:
///   1. of `samples` random poses that satisfy the constraints, the `candidates` with the smallest
///      share of goals outside the ReachabilityGrid are kept
///   2. these are mapped in one trial, the better third in three, with few frames (score.hpp)
///   3. the best `refine` dissimilar ones are improved over all trials by a compass search over
///      shift and turn (refine.hpp): all with coarse steps, the better half with fine steps
///   4. the best `plan` dissimilar ones are planned in full and sorted by the cost of their plans
/// Equal arguments give equal placements. Throws InputError if no pose is allowed.
std::vector<PlacementResult> find_placements(const planning::PlanningInputs& planner,
                                             const std::vector<TrialMovement>& trials,
                                             const PlaceOptions& options,
                                             const ProgressCallback& report);

/// Returns the cost of a placement's plans.
double plan_cost(const PlacementResult& placed);

/// Plans every trial in full with one placement, on `jobs` threads.
PlacementResult plan_with_placement(const planning::PlanningInputs& planner,
                                    const std::vector<TrialMovement>& trials,
                                    const map::PlacementOptions& placement, int jobs);

}  // namespace morphe::place
