#pragma once

#include <string>

#include "pipeline/place/place.hpp"

namespace morphe::place {

/// The shares of fingertip goals in reach, for a pose shifted horizontally to the nodes of a grid.
struct ReachabilityMap {
  BasePlacement pose;                                ///< before it is shifted
  std::vector<double> right, forward;                ///< shoulder offsets [m]
  std::vector<std::vector<double>> reachable_share;  ///< [forward][right], NaN if not allowed
  Vec3 base;                ///< origin of the base of `pose` relative to the human shoulder [m]
  std::vector<Vec3> goals;  ///< of the tips, relative to the human shoulder [m]
};

/// Evaluates all offsets of the grid in a few trials, with height and rotation of a placement.
ReachabilityMap reachability_map(const planning::PlanningInputs& planner,
                                 const std::vector<TrialMovement>& trials,
                                 const PlacementResult& placed, const PlaceOptions& options,
                                 const ProgressCallback& report);

/// Draws the map in plan view, forward up: cells from red (no goal in reach) to green, base, goals.
std::string svg_of(const ReachabilityMap& map);

}  // namespace morphe::place
