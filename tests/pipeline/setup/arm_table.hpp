#pragma once

#include <string>
#include <vector>

namespace morphe::setup {

/// A joint of a robot of straight lines: all link frames are parallel to the base at zero.
struct TableJoint {
  std::string name, parent;    ///< the joint before it, "" for the base
  char axis = 'z';             ///< x, y or z; X, Y or Z if it slides; f if it is fixed
  double x = 0, y = 0, z = 0;  ///< in the base frame [m]
};

/// A robot and the roles of its joints, known from its makers' drawings.
struct TableRobot {
  std::string name;
  std::vector<TableJoint> joints;
  std::string arm;    ///< answer to --arm: joint whose link ends the arm, or ""
  std::string first;  ///< joint of the arm
  std::string elbow;
  std::vector<std::string> shoulder;    ///< joints whose axes pass the shoulder
  std::vector<std::string> wrist;       ///< joints whose axes pass the wrist
  std::vector<std::string> trunk = {};  ///< joints that stay fixed
};

/// Returns robots like public ones, by their figures.
std::vector<TableRobot> table_robots();

}  // namespace morphe::setup
