#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/motion/robot_model.hpp"
#include "core/robot/files/description.hpp"

namespace morphe::robot {

/// Returns the robot as a URDF. Every frame becomes a joint and its child link, both with the
/// frame's name, below the root link `base` (`base_root` if a frame has that name). Coupled frames
/// mimic the joint that drives them. Every tip becomes a fixed link, and a capsule a cylinder with
/// a sphere at both ends. Efforts are written as 0; acceleration, jerk, centres and allowed pairs
/// are lost. When the URDF is loaded again, all frames have the same poses within rounding. The
/// frame with a joint's name, else the joint's first frame, must have ratio 1, as load_robot()
/// makes it.
std::string urdf_of(const RobotModel& robot);

/// A URDF and the data that it lacks.
struct WrittenUrdf {
  std::string text;
  std::vector<std::string> unknown;  ///< sentences on that data, which are comments of the text
};

/// Returns the robot as a URDF for a file in `folder`, with the data of the robot's original URDFs
/// beyond kinematics: names of links and joints, visuals, collision shapes, inertias, efforts,
/// dynamics. Capsules are written only for links without collision shapes. The root link of a URDF
/// is kept as the root if its frame is at the base and all other frames descend from it.
WrittenUrdf urdf_of(const RobotDescription& robot, const std::filesystem::path& folder);

}  // namespace morphe::robot
