#pragma once

#include <string>

#include "pipeline/place/place.hpp"

namespace morphe::commands {

/// Returns the head of a table of placements, without a newline at the end.
std::string place_table_head();
/// Returns the row of a placement in this table, without a newline; `name` is its first cell.
std::string place_row(const std::string& name, const robot::Standing& standing,
                      const place::PlacementResult& found);

/// Returns the section `placement` of a config.
std::string placement_yaml(const map::PlacementOptions& placement);

/// Returns lines about the search: movements that fail at any placement, a robot that must stand
/// upright, and a best placement that is no better than the configured one.
std::string place_notes(const place::PlaceOptions& options,
                        const place::PlacementResult& configured,
                        const std::vector<place::PlacementResult>& found);

/// Returns the configured placement and those found, the best first, as JSON.
std::string place_json(const robot::Standing& standing, const place::PlacementResult& configured,
                       const std::vector<place::PlacementResult>& found);

}  // namespace morphe::commands
