#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/core/robot/files/written_robot.hpp"

namespace morphe::robot {

/// In the test's own folder.
inline std::filesystem::path write_text(const std::string& name, const std::string& text) {
  const std::filesystem::path file = robot_folder() / name;
  std::ofstream(file) << text;
  return file;
}

/// Two joints, and two that copy them; a shape of each kind.
inline const std::string kUrdf = R"(<?xml version="1.0"?>
<robot name="two">
  <link name="stand">
    <collision><geometry><box size="0.1 0.4 0.1"/></geometry></collision>
  </link>
  <joint name="a" type="revolute">
    <parent link="stand"/>
    <child link="upper"/>
    <origin xyz="0 0 1" rpy="0.1 0.2 0.3"/>
    <axis xyz="0 2 0"/>
    <limit lower="-1" upper="1" effort="1" velocity="2"/>
  </joint>
  <link name="upper">
    <collision><origin xyz="0 0 0.2"/><geometry><cylinder radius="0.05" length="0.4"/></geometry></collision>
  </link>
  <joint name="plate" type="fixed">
    <parent link="lower"/>
    <child link="tool"/>
    <origin xyz="0 0 0.1"/>
  </joint>
  <joint name="b" type="continuous">
    <parent link="upper"/>
    <child link="lower"/>
    <origin xyz="0 0 0.4"/>
    <axis xyz="0 1 0"/>
  </joint>
  <link name="lower">
    <collision name="ball"><geometry><sphere radius="0.06"/></geometry></collision>
  </link>
  <joint name="c" type="revolute">
    <parent link="lower"/>
    <child link="finger"/>
    <origin xyz="0 0 0.3"/>
    <axis xyz="1 0 0"/>
    <limit lower="-3" upper="3" effort="1" velocity="2"/>
    <mimic joint="d" multiplier="2" offset="0.5"/>
  </joint>
  <joint name="d" type="revolute">
    <parent link="tool"/>
    <child link="other"/>
    <axis xyz="0 0 1"/>
    <limit lower="-3" upper="3" effort="1" velocity="2"/>
    <mimic joint="a" multiplier="-1" offset="0.25"/>
  </joint>
  <link name="finger"/>
  <link name="tool"/>
  <link name="other"/>
</robot>
)";
inline const std::string kDescription = R"(name: two
urdf:
  file: two.urdf
  srdf: two.srdf
  acceleration: 5
  jerk: 50
  limits:
    - {joint: b, lower: -90 deg, upper: 90 deg, velocity: 3, jerk: 70}
chains:
  - {name: arm, first: a, last: tool}
palm: tool
tips:
  - {name: end, frame: finger, finger: index, mount: {position: [0, 0, 0.1]}}
collision:
  may_touch_target: [ball]
)";
inline const std::string kSrdf = R"(<robot name="two">
  <disable_collisions link1="stand" link2="lower" reason="Never"/>
</robot>
)";

}  // namespace morphe::robot
