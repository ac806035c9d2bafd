#pragma once

#include "core/collision/world.hpp"
#include "pipeline/place/base_placement.hpp"
#include "pipeline/place/constants.hpp"
#include "pipeline/place/trial_movements.hpp"
#include "stages/map/movement_search.hpp"

namespace morphe::place {

/// The measures of a pose on a movement, or their means over several movements.
struct PlacementMeasures {
  double out_of_reach = 0;     ///< share of tip goals that are missed by over kReachTolerance_m
  double tip_error_m = 0;      ///< mean error, each limited to kMaxTipError_m
  double collision_share = 0;  ///< share of frames with a clearance below the margin
  double penetration_m = 0;    ///< mean over the frames of the clearance missing to the margin
  double upper_arm_error = 0;  ///< mean angle between the upper arms of robot and human [rad]
  double palm_error = 0;       ///< mean angle between the palm and the human hand [rad]
  double near_limits = 0;      ///< mean over the frames of how near an arm joint is to a limit:
                               ///< 1 at the limit, 0 from a distance of kLimitZone_rad on
  double speed_ratio = 0;      ///< largest velocity divided by its limit, at the human's speed
};
/// Returns the mean of several measures, each with the same weight.
PlacementMeasures mean_of(const std::vector<PlacementMeasures>& all);

/// Returns the cost, as an equivalent error of the upper arm in degrees. It is the sum of
///   5     per percent of goals out of reach and 2 per millimetre of tip error, because a plan
///         must reach its goals in any case
///   1     per percent of colliding frames and 1 per millimetre of depth, because repair can
///         resolve small collisions
///   1     per degree of the upper arm
///   0.15  per degree of the palm, which always differs by 25-50 degrees, depending on the hand
///   10    for a joint at its limit in all frames, and 10 for twice a speed limit, because these
///         only slow the motion down
double cost_of(const PlacementMeasures& measures);

/// Returns the measures of postures `q` [frames of problem, n].
PlacementMeasures measure(const map::MappingProblem& problem, const JointRows& q);

/// The result of evaluating a pose on some frames of a movement.
struct TrialMapping {
  JointRows q;  ///< [frames, n]
  PlacementMeasures measures;
};
/// Evaluates a pose by searching postures from random starts.
TrialMapping map_from_random_starts(const planning::PlanningInputs& planner,
                                    const BasePlacement& pose, const TrialMovement& trial,
                                    const SearchEffort& effort, std::uint64_t seed);
/// Evaluates a pose by smoothing the postures `start` of a nearby pose, without a search.
TrialMapping map_from_warm_start(const planning::PlanningInputs& planner, const BasePlacement& pose,
                                 const TrialMovement& trial, const SearchEffort& effort,
                                 const JointRows& start);

}  // namespace morphe::place
