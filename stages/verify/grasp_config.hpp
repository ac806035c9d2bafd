#pragma once

#include <optional>
#include <string>

namespace morphe::verify {

/// Returns a number from the section `grasp` of an effective config in the form stored in plans.h5
/// (one key per line, sections not indented); nullopt if there is no such key with a number.
std::optional<double> grasp_config_value(const std::string& config, const std::string& key);

}  // namespace morphe::verify
