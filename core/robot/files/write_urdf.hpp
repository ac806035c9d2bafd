#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/motion/robot_model.hpp"
#include "core/robot/files/description.hpp"

namespace morphe::robot {

/// Returns the robot as a URDF. Every frame becomes a joint and its child link, both with the
/// frame's name, below the root link `base` (`base_root` if a frame has that name); coupled joints
/// mimic the joint that drives them; every tip is a fixed link; a capsule is a cylinder with a
/// sphere at both ends. Efforts are unknown and written as 0. Data that a URDF cannot express is
/// lost: acceleration, jerk, centres, allowed pairs. When the URDF is loaded again, all frames have
/// the same poses within rounding. The robot must come from load_robot(): the first frame of every
/// joint must rotate by the joint's angle itself.
std::string urdf_of(const RobotModel& robot);

/// A URDF and the data that it lacks.
struct WrittenUrdf {
  std::string text;
  std::vector<std::string> unknown;  ///< a sentence each; the text contains them as a comment
};

/// Returns the robot as a URDF that includes the data of the robot's original URDFs beyond
/// kinematics, for a file in `folder`: names of links and joints, visuals, collision shapes
/// (Morphe's capsules only for links that have no shapes), inertias, efforts, dynamics. The root of
/// a URDF becomes the root if all other frames descend from it.
WrittenUrdf urdf_of(const RobotDescription& robot, const std::filesystem::path& folder);

}  // namespace morphe::robot
