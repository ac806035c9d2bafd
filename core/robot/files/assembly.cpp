#include "core/robot/files/assembly.hpp"

#include <utility>

namespace morphe::robot {

std::vector<config::ConfigNode> optional_items(const config::ConfigNode& node, const char* key) {
  return node.has(key) ? node[key].items() : std::vector<config::ConfigNode>{};
}

int frame_index(const RobotModel& table, const std::string& name) {
  for (int i = 0; i < std::ssize(table.frames); ++i) {
    if (table.frames[i].name == name) return i;
  }
  return -1;
}

int find_joint(const RobotModel& table, const FileScope& scope, const std::string& name) {
  for (const std::string& reading : {scope.prefix + name, name}) {
    for (int j = 0; j < std::ssize(table.joint_names); ++j) {
      if (table.joint_names[j] == reading) return j;
    }
  }
  return -1;
}

int append_frame(RobotModel& table, RobotModel::Frame frame) {
  table.frames.push_back(std::move(frame));
  return static_cast<int>(std::ssize(table.frames)) - 1;
}

int append_joint(Assembly& assembly, const std::string& name, const JointLimits& limits) {
  assembly.limits.push_back(limits);
  assembly.table.joint_names.push_back(name);
  return static_cast<int>(std::ssize(assembly.limits)) - 1;
}

void set_limits(Assembly& assembly) {
  const auto column = [&](double JointLimits::*member) {
    JointVector values(std::ssize(assembly.limits));
    for (int j = 0; j < values.size(); ++j) values[j] = assembly.limits[j].*member;
    return values;
  };
  RobotModel& table = assembly.table;
  table.lower = column(&JointLimits::lower);
  table.upper = column(&JointLimits::upper);
  table.velocity = column(&JointLimits::velocity);
  table.acceleration = column(&JointLimits::acceleration);
  table.jerk = column(&JointLimits::jerk);
}

}  // namespace morphe::robot
