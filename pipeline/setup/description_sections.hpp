#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/robot/files/robot_description.hpp"
#include "pipeline/setup/urdf_analysis.hpp"

namespace morphe::setup {

// The sections of a generated description, each a YAML text of top-level keys, "" if there is none
// to write. A remark behind an entry says how certain it is.

/// The URDF's path and the limits that it lacks.
std::string urdf_section(const SetupRequest& request, const std::vector<JointLimits>& limits);
/// What neither the URDF nor the manufacturer states, of limits and geometry.
std::string assumed_section(const UrdfAnalysis& found, const std::vector<JointLimits>& limits);
/// The arm and the fingers as chains.
std::string chains_section(const UrdfAnalysis& found);
/// The joint centres of the arm, flange and palm as frames, and which are shoulder and palm.
std::string frames_section(const UrdfAnalysis& found);
/// The joints before the shoulder, fixed where they rest.
std::string fixed_joints_section(const UrdfAnalysis& found);
/// The pads.
std::string tips_section(const UrdfAnalysis& found);
/// The joint centres of the arm and the fingers.
std::string centres_section(const UrdfAnalysis& found);
/// The natural posture of the fingers.
std::string natural_section(const UrdfAnalysis& found);
/// The capsules, and the text of the pairs of links that may collide.
std::string capsules_section(const UrdfAnalysis& found, const std::string& allowed);
/// Returns a function that names the links of frames, because `allowed_links` does.
std::function<std::string(int)> link_names(const robot::RobotDescription& description);
/// The sentences on what should be checked.
std::string check_section(const std::vector<std::string>& items);

}  // namespace morphe::setup
