#pragma once

#include <string>

#include "pipeline/place/place.hpp"

namespace morphe::commands {

/// A row a placement: what full plans from there are like, and where it is. Without a newline at
/// the end.
std::string place_table_head();
std::string place_row(const std::string& name, const place::Found& found);

/// The config section, indented by nothing.
std::string placement_yaml(const map::PlacementOptions& placement);

std::string place_json(const place::Found& given, const std::vector<place::Found>& found);

}  // namespace morphe::commands
