#pragma once

#include <string>
#include <vector>

#include "core/robot/files/robot_description.hpp"
#include "pipeline/setup/urdf_analysis.hpp"

namespace morphe::setup {

// The sections of a generated description, each a YAML text of top-level keys, "" if there is none
// to write. A remark behind an entry says how certain it is.

/// The URDF's path and the limits that it lacks.
std::string urdf_section(const SetupRequest& request, const std::vector<JointLimits>& limits);
/// The arm and the fingers as chains.
std::string chains_section(const UrdfAnalysis& found);
/// The joint centres of the arm, flange and palm as frames, and which are shoulder and palm.
std::string frames_section(const UrdfAnalysis& found);
/// The pads.
std::string tips_section(const UrdfAnalysis& found);
/// The joint centres of the arm and the fingers.
std::string centres_section(const UrdfAnalysis& found);
/// The natural posture of the fingers.
std::string natural_section(const UrdfAnalysis& found);
/// The capsules, and the text of the pairs of links that may collide.
std::string capsules_section(const UrdfAnalysis& found, const std::string& allowed);
/// The key `allowed_links` for a description that lacks it. It names links, because their names
/// differ from those of frames.
std::string pairs_text(const robot::RobotDescription& description);

}  // namespace morphe::setup
