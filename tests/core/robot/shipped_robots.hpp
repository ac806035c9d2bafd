#pragma once

#include <algorithm>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "core/robot/files/description.hpp"

namespace morphe::robot {

inline std::filesystem::path robot_file(const std::string& name) {
  return std::filesystem::path(MORPHE_SOURCE_DIR) / "configs/robots" / (name + ".yaml");
}
inline RobotModel shipped_robot(const std::string& name) {
  return load_robot(robot_file(name)).table;
}

/// Names of every description in configs/robots.
inline std::vector<std::string> shipped_robots() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(robot_file("any").parent_path())) {
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem());
  }
  std::ranges::sort(names);
  return names;
}

inline JointVector random_position(const RobotModel& robot, std::mt19937& random) {
  JointVector q(robot.lower.size());
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    q[i] = std::uniform_real_distribution<>(robot.lower[i], robot.upper[i])(random);
  }
  return q;
}

inline JointVector zero_position(const RobotModel& robot) {
  return JointVector::Zero(robot.lower.size());
}

inline std::size_t frame_named(const RobotModel& robot, const std::string& name) {
  const auto found = std::ranges::find(robot.frames, name, &RobotModel::Frame::name);
  return static_cast<std::size_t>(found - robot.frames.begin());
}

inline std::size_t tip_named(const RobotModel& robot, const std::string& name) {
  const auto found = std::ranges::find(robot.tips, name, &RobotModel::Tip::name);
  return static_cast<std::size_t>(found - robot.tips.begin());
}

}  // namespace morphe::robot
