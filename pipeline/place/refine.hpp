#pragma once

#include "pipeline/place/score.hpp"

namespace morphe::place {

/// A placement with its measures over the trials.
struct Candidate {
  /// The placement.
  BasePlacement stand;
  /// The mean measures.
  PlacementMeasures measures;
  /// The cost of the measures.
  double cost = 0;
};

/// Evaluates a placement as the mean over the trials by a search from random starts.
Candidate evaluate_placement(const planning::PlanningInputs& planner, const BasePlacement& stand,
                             const std::vector<const TrialMovement*>& trials,
                             const SearchEffort& effort, std::uint64_t seed);

/// The steps of a compass search.
struct CompassSteps {
  /// The first steps: shift [m] and turn [rad].
  double shift_m = 0.12, turn_rad = 24 * kRadPerDegree;
  /// The number of levels, each with half the steps of the previous one.
  int levels = 4;
};

/// Improves a placement by a compass search over shift and turn about the world's axes: it moves
/// along each of the six directions as long as the cost decreases, at each level with half the
/// steps of the previous one. Postures are warm-started from those of the last improvement; at each
/// level they are searched again from random starts. The result is always allowed and never worse
/// than the search result at `start`.
Candidate refine(const planning::PlanningInputs& planner, const BasePlacement& start,
                 const CompassSteps& steps, const BasePlacement& configured,
                 const std::vector<TrialMovement>& trials, const Vec3& robot_shoulder,
                 const PlaceOptions& options, std::uint64_t seed);

}  // namespace morphe::place
