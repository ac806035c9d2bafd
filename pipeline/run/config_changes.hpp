#pragma once

#include <string>
#include <vector>

namespace morphe::run {

/// Returns the differences of two effective configs (YAML), key by key: "map.starts 32 -> 64". A
/// list counts as one value; "none" denotes an absent key.
std::vector<std::string> config_changes(const std::string& before, const std::string& after);

}  // namespace morphe::run
