#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/motion/robot_table.hpp"
#include "core/robot/files/description.hpp"

namespace morphe::robot {

/// The robot as a URDF. Every frame is a joint and the link below it, both by its name, below the
/// root link `base` (`base_root` if a frame is called so); coupled joints mimic the one that drives
/// them; every tip is a fixed link; a capsule is a cylinder with a sphere at both ends. Efforts are
/// not known: 0. What a URDF cannot say is lost: acceleration, jerk, centres, allowed pairs. Loaded
/// again, all frames stand where they stood, within rounding. The robot must be one that
/// load_robot() gives: the first frame of every joint turns by the joint's angle itself.
std::string urdf_of(const RobotTable& robot);

struct WrittenUrdf {
  std::string text;
  std::vector<std::string> unknown;  ///< a sentence each; the text holds them as a comment
};

/// The same with what the URDFs that the robot comes from say beyond motion, for a file in
/// `folder`: names of links and joints, visuals, collision shapes (Morphe's capsules only where a
/// link has none), inertias, efforts, dynamics. A URDF's root is the root, if all hangs on it.
WrittenUrdf urdf_of(const RobotDescription& robot, const std::filesystem::path& folder);

}  // namespace morphe::robot
