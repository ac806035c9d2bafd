#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/robot/files/description.hpp"

namespace morphe::robot {

/// The smallest description, to be appended to.
inline const std::string kOneJoint = R"(name: small
chains:
  - name: arm
    joints:
      - {name: turn, theta: 0, d: 0, a: 0, alpha: 0, lower: -1, upper: 1, velocity: 1, acceleration: 1, jerk: 1}
tips: [{name: end, chain: arm, finger: wrist}]
)";

/// A folder for this test alone: ctest runs several at once.
inline std::filesystem::path robot_folder() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string("morphe_") + test->test_suite_name() + "_" + test->name();
  std::ranges::replace(name, '/', '_');
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / name;
  std::filesystem::create_directories(folder);
  return folder;
}

inline std::filesystem::path write_robot(const std::string& name, const std::string& yaml) {
  const std::filesystem::path file = robot_folder() / (name + ".yaml");
  std::ofstream(file) << yaml;
  return file;
}

inline RobotModel written_robot(const std::string& name, const std::string& yaml) {
  return load_robot(write_robot(name, yaml)).table;
}

}  // namespace morphe::robot
