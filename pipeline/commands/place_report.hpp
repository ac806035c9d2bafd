#pragma once

#include <string>

#include "pipeline/place/place.hpp"

namespace morphe::commands {

/// Returns the head of a table with one row per placement: the results of full plans and the
/// placement itself. There is no newline at the end.
std::string place_table_head();
/// Returns the row of a placement.
std::string place_row(const std::string& name, const place::PlacementResult& found);

/// Returns the config section without indentation.
std::string placement_yaml(const map::PlacementOptions& placement);

/// Returns the given placement and the found ones as JSON.
std::string place_json(const place::PlacementResult& configured,
                       const std::vector<place::PlacementResult>& found);

}  // namespace morphe::commands
