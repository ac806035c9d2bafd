#pragma once

#include <optional>
#include <string>

namespace morphe::verify {

/// A number of the section `grasp` of an effective config, as plans.h5 holds it (a key a line,
/// sections not indented); nothing where it is not there.
std::optional<double> stated_for_grasp(const std::string& config, const std::string& key);

}  // namespace morphe::verify
