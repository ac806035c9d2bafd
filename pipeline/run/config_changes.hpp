#pragma once

#include <string>
#include <vector>

namespace morphe::run {

/// What differs between two effective configs (YAML), key by key: "map.starts 32 -> 64". Lists
/// count as one value; "none" stands for a key that is not there.
std::vector<std::string> config_changes(const std::string& before, const std::string& after);

}  // namespace morphe::run
