#pragma once

#include <string>
#include <vector>

namespace morphe::run {

/// Returns the changed keys of two configs (YAML): "map.starts 32 -> 64", "none" for an absent one.
std::vector<std::string> config_changes(const std::string& before, const std::string& after);

}  // namespace morphe::run
