#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/motion/human_motion.hpp"
#include "pipeline/setup/capsules.hpp"
#include "pipeline/setup/flange.hpp"
#include "pipeline/setup/joint_centres.hpp"
#include "pipeline/setup/limits.hpp"
#include "pipeline/setup/setup.hpp"

namespace morphe::setup {

/// All that is derived from a URDF for its description. The robot must outlive it.
struct UrdfAnalysis {
  const Kinematics& robot;
  std::vector<int> arm;  ///< moving frames from the base to the hand's root or the last one
  std::optional<Hand> hand;
  std::vector<Pad> pads;
  std::optional<Palm> palm;
  std::optional<Flange> flange;
  std::optional<ArmCentres> centres;
  std::vector<LinkCapsules> capsules;
  std::vector<std::string> placeholder_shape_links;  ///< links that lost placeholder shapes

  /// Returns a name for a generated frame that no frame, joint or link of the file has.
  std::string unique_frame_name(std::string name) const {
    while (robot.model->links.contains(name) || robot.model->joint(name)) name += "_of_setup";
    return name;
  }
  std::string link(int frame) const { return robot.link[frame]; }
  std::string joint(int frame) const { return robot.frame(frame).name; }
  /// Returns false for one or two joints, which are the wrist of a hand.
  bool has_arm() const { return arm.size() > 2; }
  std::string finger_name(const Finger& finger) const { return kFingerNames[finger.finger]; }
};

/// Derives it. Shapes of fingers that only stand in for others are taken out of `shapes`. Throws
/// InputError for a URDF without hand and arm.
UrdfAnalysis analyse_urdf(const Kinematics& robot, const SetupRequest& request, LinkShapes shapes);

}  // namespace morphe::setup
