#pragma once

#include "core/collision/world.hpp"
#include "pipeline/place/base_placement.hpp"
#include "pipeline/place/trial_movements.hpp"
#include "stages/map/movement_search.hpp"

namespace morphe::place {

/// The measures of a placement for one movement (means over its frames), or for several (means of
/// these).
struct PlacementMeasures {
  /// Share of tip goals that are missed by more than 2 mm.
  double out_of_reach = 0;
  /// Mean error of the tips, each limited to 200 mm [m].
  double tip_error_m = 0;
  /// Share of frames with a clearance below the margin.
  double collision_share = 0;
  /// Mean deficit of the clearance with respect to the margin [m].
  double penetration_m = 0;
  /// Angle between the directions of the upper arms [rad].
  double upper_arm_error = 0;
  /// Angle between the robot's palm frame and the human hand's [rad].
  double palm_error = 0;
  /// 0 … 1: depth of the arm's joints in the last 0.15 rad before their limits.
  double near_limits = 0;
  /// Largest velocity divided by its limit, at the human's tempo.
  double speed_ratio = 0;
};
/// Computes the mean of several measures.
PlacementMeasures mean_of(const std::vector<PlacementMeasures>& all);

/// Computes the cost as an equivalent error of the upper arm in degrees. Lower is better.
///   5     per percent of goals out of reach and 2 per millimetre of tip error, because a plan
///         must reach its goals in any case
///   1     per percent of colliding frames and 1 per millimetre of depth, because repair can
///         resolve small collisions
///   1     per degree of the upper arm
///   0.15  per degree of the palm, which differs by 25-50 degrees in any case, hand by hand
///   10    for joints at their limits all the time and 10 for twice a speed limit, because
///         these only reduce the tempo
double cost_of(const PlacementMeasures& measures);

/// Computes the measures of postures [frames of problem, joints].
PlacementMeasures measure(const map::MappingProblem& problem, const JointRows& q);

/// The effort with which a placement is evaluated.
struct SearchEffort {
  /// Number of frames per movement.
  std::size_t frames = 8;
  /// The number of key frames and of random starts.
  int key_frames = 2, starts = 6;
};

/// Returns the config with the given placement and effort.
planning::PipelineConfig trial_config(const planning::PipelineConfig& config,
                                      const BasePlacement& stand, const SearchEffort& effort);

/// The result of evaluating a placement on a movement.
struct TrialMapping {
  /// The postures of the few frames.
  JointRows q;
  /// The measures of the postures.
  PlacementMeasures measures;
};
/// Evaluates a placement by a search from random starts.
TrialMapping map_from_random_starts(const planning::PlanningInputs& planner,
                                    const BasePlacement& stand, const TrialMovement& trial,
                                    const SearchEffort& effort, std::uint64_t seed);
/// Evaluates a placement by smoothing from the postures of a nearby placement, without a search.
TrialMapping map_from_warm_start(const planning::PlanningInputs& planner,
                                 const BasePlacement& stand, const TrialMovement& trial,
                                 const SearchEffort& effort, const JointRows& near);

}  // namespace morphe::place
