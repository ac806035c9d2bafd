#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/motion/assumption.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::robot {

/// The subjects of the key `assumed` of a description.
inline constexpr std::array<Knowable, 3> kAssumedSubjects{Knowable::limits, Knowable::mount,
                                                          Knowable::geometry};

/// The natural posture of a joint, which applies while no goal determines the joint: q = value, or
/// q = q_follow + value if `follow` is not empty.
struct NaturalJoint {
  std::string joint, follow;
  double value = 0;  ///< [rad or m]
};

/// A URDF of the robot, and the frames that its links became.
struct UrdfSource {
  std::filesystem::path file;
  std::string prefix;                ///< of its names in the robot
  std::map<std::string, int> links;  ///< frames by the names of links in the file
};

/// A robot description as read from its files.
struct RobotDescription {
  RobotModel table;
  std::vector<std::filesystem::path> files;  ///< all files that were read, the main one first
  std::vector<std::string> notes;            ///< as Assembly::notes
  std::vector<NaturalJoint> natural;         ///< default of a config's `map.natural_posture`
  std::map<std::string, int> links;          ///< frames by the prefixed names of links
  std::vector<UrdfSource> urdfs;
  /// Sentences on what its author assumed, to be checked before the robot is used.
  std::vector<std::string> checks;
  /// Properties that its files state as assumed, not known from the manufacturer (key `assumed`).
  std::vector<Assumption> assumed;
};

}  // namespace morphe::robot
