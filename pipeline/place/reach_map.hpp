#pragma once

#include <string>

#include "pipeline/place/place.hpp"

namespace morphe::place {

/// A placement, and the same shifted level: what share of goals is in reach from there.
struct ReachMap {
  Stand stand;
  std::vector<double> right, forward;    ///< shoulder offsets [m]
  std::vector<std::vector<double>> met;  ///< [forward][right] share of tip goals, NaN: not allowed
  Vec3 base;                             ///< the base's origin from the human shoulder [m]
  std::vector<Vec3> goals;               ///< tip goals from the human shoulder [m]
};

/// 13 x 13 offsets in steps of 100 mm over the box that is searched, at the height and turned as a
/// placement, over at most three trials: mapped with few frames, a goal is in reach within 2 mm.
ReachMap reach_map(const planning::Planner& planner, const std::vector<Trial>& trials,
                   const Found& found, const PlaceOptions& options, const Report& report);

/// The map in plan view, the person's right to the right and forward up: cells from red (no goal in
/// reach) to green (all), person, base and goals. The same map gives the same text.
std::string svg_of(const ReachMap& map);

}  // namespace morphe::place
