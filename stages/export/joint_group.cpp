#include "stages/export/joint_group.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/motion/input_error.hpp"
#include "core/robot/tree.hpp"

namespace morphe::exports {
namespace {

[[noreturn]] void fail(const std::string& asked, const std::string& what) {
  throw InputError(fmt::format("--group {}: {}", asked, what));
}

std::size_t find_joint(const RobotModel& robot, const std::string& asked, const std::string& name) {
  const auto found = std::ranges::find(robot.joint_names, name);
  if (found == robot.joint_names.end()) {
    fail(asked, fmt::format("{} has no joint '{}': its joints are {}", robot.name, name,
                            fmt::join(robot.joint_names, ", ")));
  }
  return found - robot.joint_names.begin();
}

/// Returns the joints of NAME=FIRST..LAST.
std::vector<int> joint_range(const RobotModel& robot, const std::string& asked,
                             std::size_t equals) {
  const std::size_t dots = asked.find("..", equals);
  if (equals == 0 || dots == std::string::npos) {
    fail(asked, fmt::format("must be {}", kGroupHelp));
  }
  if (asked.find('/') < equals) fail(asked, "a file name cannot contain '/'");
  const std::size_t first = find_joint(robot, asked, asked.substr(equals + 1, dots - equals - 1));
  const std::size_t last = find_joint(robot, asked, asked.substr(dots + 2));
  if (first > last) {
    fail(asked, fmt::format("'{}' comes after '{}': swap them", robot.joint_names[first],
                            robot.joint_names[last]));
  }
  std::vector<int> joints;
  for (std::size_t j = first; j <= last; ++j) joints.push_back(static_cast<int>(j));
  return joints;
}

/// Returns the frame at the end of the arm: the last frame on the chain to the palm whose name ends
/// with flange, since a hand may have a wrist of its own beyond it; the palm if there is no such
/// frame.
int flange_frame(const RobotModel& robot) {
  for (const int frame : robot::ancestors(robot, robot.palm_frame)) {
    if (robot.frames[frame].name.ends_with("flange")) return frame;
  }
  return robot.palm_frame;
}

std::vector<int> arm_or_hand_joints(const RobotModel& robot, const std::string& asked) {
  if (asked != "all" && asked != "arm" && asked != "hand") {
    fail(asked, fmt::format("must be {}", kGroupHelp));
  }
  const int end = flange_frame(robot);
  std::vector<int> joints;
  for (int joint = 0; joint < static_cast<int>(robot.joints()); ++joint) {
    const bool arm = robot::joint_moves_frame(robot, joint, end);
    if (asked == "all" || arm == (asked == "arm")) joints.push_back(joint);
  }
  if (joints.empty()) {
    fail(asked, fmt::format("{} has no joints of {}: omit --group", robot.name,
                            asked == "arm" ? "an arm" : "a hand"));
  }
  return joints;
}

}  // namespace

JointGroup joint_group(const RobotModel& robot, const std::string& asked) {
  const std::size_t equals = asked.find('=');
  const bool own = equals != std::string::npos;
  JointGroup group{asked.substr(0, equals), {}, {}, {}};
  group.joints = own ? joint_range(robot, asked, equals) : arm_or_hand_joints(robot, asked);
  for (const int joint : group.joints) {
    group.names.push_back(robot.joint_names[joint]);
    group.units.push_back(robot::is_prismatic(robot, joint) ? "m" : "rad");
  }
  return group;
}

Trajectory select_joints(const Trajectory& trajectory, const JointGroup& group) {
  Trajectory part = trajectory;
  for (JointRows Trajectory::*rows :
       {&Trajectory::position, &Trajectory::velocity, &Trajectory::acceleration}) {
    part.*rows = (trajectory.*rows)(Eigen::all, group.joints).eval();
  }
  return part;
}

}  // namespace morphe::exports
