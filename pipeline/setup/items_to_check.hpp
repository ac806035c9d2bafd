#pragma once

#include <string>
#include <vector>

#include "pipeline/setup/urdf_analysis.hpp"

namespace morphe::setup {

/// Returns a sentence for each property that was derived or assumed and should be checked before
/// the robot is used, in order of importance.
std::vector<std::string> items_to_check(const UrdfAnalysis& found,
                                        const std::vector<JointLimits>& limits);

}  // namespace morphe::setup
