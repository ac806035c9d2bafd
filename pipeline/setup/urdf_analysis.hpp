#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/motion/human_motion.hpp"
#include "pipeline/setup/capsules.hpp"
#include "pipeline/setup/find_limb.hpp"
#include "pipeline/setup/flange.hpp"
#include "pipeline/setup/limits.hpp"
#include "pipeline/setup/setup.hpp"

namespace morphe::setup {

/// All that is derived from a URDF for its description. The robot must outlive it.
struct UrdfAnalysis {
  const Kinematics& robot;
  std::vector<int> arm;  ///< moving frames of the arm, or of the wrist of a hand
  std::optional<Hand> hand;
  std::vector<Pad> pads;
  std::optional<Palm> palm;
  std::optional<Flange> flange;
  std::optional<Arm> roles;  ///< of the frames of an arm, and its joint centres
  std::vector<LinkCapsules> capsules;
  std::vector<std::string> placeholder_shape_links;  ///< links that lost placeholder shapes
  std::vector<std::string> notes;
  double opening_m = 0;  ///< of a gripper, between its pads

  /// Returns a name for a generated frame that no frame, joint or link of the file has.
  std::string unique_frame_name(std::string name) const {
    while (robot.model->links.contains(name) || robot.model->joint(name)) name += "_of_setup";
    return name;
  }
  std::string link(int frame) const { return robot.link[frame]; }
  std::string joint(int frame) const { return robot.frame(frame).name; }
  bool has_arm() const { return roles.has_value(); }
  std::string finger_name(const Finger& finger) const { return kFingerNames[finger.finger]; }
};

/// Derives it. Shapes of fingers that only stand in for others are taken out of `shapes`. Throws
/// InputError for a URDF without hand and arm.
UrdfAnalysis analyse_urdf(const Kinematics& robot, const SetupRequest& request, LinkShapes shapes);

}  // namespace morphe::setup
