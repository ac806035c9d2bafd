#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::robot {

/// What a joint does while no goal asks anything of it: q = value, or q = q_follow + value.
struct NaturalJoint {
  std::string joint, follow;
  double value = 0;  ///< [rad or m]
};

/// A URDF of the robot, and the frames that its links are.
struct UrdfSource {
  std::filesystem::path file;
  std::string prefix;                ///< of its names in the robot
  std::map<std::string, int> links;  ///< by the file's own names
};

struct RobotDescription {
  RobotTable table;
  std::vector<std::filesystem::path> files;  ///< every file it was read from, the first one named
  std::vector<std::string> notes;            ///< "FILE:LINE: …": what of it was left out
  std::vector<NaturalJoint> natural;         ///< what a config's `map.natural` is by default
  std::map<std::string, int> links;          ///< of its URDFs: the frame that each is
  std::vector<UrdfSource> urdfs;
};

/// Reads a robot description (docs/formats.md): DH chains, a URDF (with an SRDF), a generated arm
/// or hand, or `parts` that mount other descriptions (a hand on an arm). Throws InputError with
/// file, line and key for unknown or missing keys, a joint without limits, a coupling to an unknown
/// joint, a frame or capsule that names nothing: a line for each.
RobotDescription load_robot(const std::filesystem::path& file);
/// The same of a text that would stand in that file.
RobotDescription parse_robot(const std::string& text, const std::filesystem::path& file);

}  // namespace morphe::robot
