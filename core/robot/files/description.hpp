#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::robot {

/// The natural posture of a joint, which applies as long as no goal determines it: q = value, or q
/// = q_follow + value.
struct NaturalJoint {
  std::string joint, follow;
  double value = 0;  ///< [rad or m]
};

/// A URDF of the robot, and the frames that its links became.
struct UrdfSource {
  std::filesystem::path file;
  std::string prefix;                ///< prefix of its names in the robot
  std::map<std::string, int> links;  ///< frames by the names of links in the file
};

/// A robot description as read from its files.
struct RobotDescription {
  RobotModel table;
  std::vector<std::filesystem::path> files;  ///< all files that were read, the main one first
  /// "FILE:LINE: …": parts of the description that were ignored.
  std::vector<std::string> notes;
  std::vector<NaturalJoint> natural;  ///< default of a config's `map.natural_posture`
  std::map<std::string, int> links;   ///< links of its URDFs and their frames
  std::vector<UrdfSource> urdfs;
};

/// Reads a robot description (docs/formats.md): DH chains, a URDF (with an SRDF), a generated arm
/// or hand, or `parts` that mount other descriptions (a hand on an arm). Throws InputError with
/// file, line and key for unknown or missing keys, a joint without limits, a coupling to an unknown
/// joint, and references to frames or capsules that do not exist, one line for each.
RobotDescription load_robot(const std::filesystem::path& file);
/// Parses a robot description from a text as if it were the content of `file`.
RobotDescription parse_robot(const std::string& text, const std::filesystem::path& file);

}  // namespace morphe::robot
