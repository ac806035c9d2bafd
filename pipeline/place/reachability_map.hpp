#pragma once

#include <string>

#include "pipeline/place/place.hpp"

namespace morphe::place {

/// The share of goals in reach for a placement and for the same placement shifted horizontally.
struct ReachabilityMap {
  /// The placement that is shifted.
  BasePlacement stand;
  /// Shoulder offsets [m].
  std::vector<double> right, forward;
  /// [forward][right] share of tip goals in reach, NaN if not allowed.
  std::vector<std::vector<double>> reachable_share;
  /// Origin of the base relative to the human shoulder [m].
  Vec3 base;
  /// Tip goals relative to the human shoulder [m].
  std::vector<Vec3> goals;
};

/// Computes a map of 13 x 13 offsets in steps of 100 mm over the box of the search, with the height
/// and rotation of a placement, over at most three trials. They are mapped with few frames; a goal
/// within 2 mm is in reach.
ReachabilityMap reachability_map(const planning::PlanningInputs& planner,
                                 const std::vector<TrialMovement>& trials,
                                 const PlacementResult& found, const PlaceOptions& options,
                                 const ProgressCallback& report);

/// Draws the map in plan view, with the person's right to the right and forward up: cells from red
/// (no goal in reach) to green (all), person, base and goals. Equal maps give equal texts.
std::string svg_of(const ReachabilityMap& map);

}  // namespace morphe::place
