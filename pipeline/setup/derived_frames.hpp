#pragma once

#include <string>
#include <vector>

#include "core/robot/files/robot_description.hpp"
#include "pipeline/setup/urdf_analysis.hpp"

namespace morphe::setup {

/// Returns the joint centres, the flange and the palm as they are in a description, with their
/// certainty and the distances of axes. `kept` are the sections that a person edited.
std::vector<DerivedFrame> derived_frames(const UrdfAnalysis& found,
                                         const robot::RobotDescription& description,
                                         const std::vector<std::string>& kept);

}  // namespace morphe::setup
