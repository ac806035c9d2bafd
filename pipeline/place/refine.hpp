#pragma once

#include "pipeline/place/score.hpp"

namespace morphe::place {

/// A pose, its mean measures over the trials, and their cost.
struct Candidate {
  BasePlacement pose;
  PlacementMeasures measures;
  double cost = 0;
};

/// Evaluates a pose by searching postures from random starts in each trial.
Candidate evaluate_placement(const planning::PlanningInputs& planner, const BasePlacement& pose,
                             const std::vector<const TrialMovement*>& trials,
                             const SearchEffort& effort, std::uint64_t seed);

/// Improves a pose by a compass search over shifts along the world's axes and turns about them. A
/// step in one of these six directions, forwards or backwards, is kept if the cost decreases. Each
/// level has half the steps of the previous one and at most kMaxRounds rounds over all directions.
/// Postures start from those of the last improvement; at the begin of each level they are searched
/// from random starts as well. The result is never worse than the first such search at `start`.
/// `start` must be allowed; the result is. `robot_shoulder` is in the base frame.
Candidate refine(const planning::PlanningInputs& planner, const BasePlacement& start,
                 const CompassSteps& steps, const BasePlacement& configured,
                 const std::vector<TrialMovement>& trials, const Vec3& robot_shoulder,
                 const PlaceOptions& options, std::uint64_t seed);

}  // namespace morphe::place
