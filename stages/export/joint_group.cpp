#include "stages/export/joint_group.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <numeric>

#include "core/motion/input_error.hpp"
#include "core/robot/tree.hpp"

namespace morphe::exports {
namespace {

[[noreturn]] void fail(const std::string& selection, const std::string& message) {
  throw InputError(fmt::format("--group {}: {}", selection, message));
}

int find_joint(const RobotModel& robot, const std::string& selection, const std::string& name) {
  for (int j = 0; j < std::ssize(robot.joint_names); ++j) {
    if (robot.joint_names[j] == name) return j;
  }
  fail(selection, fmt::format("{} has no joint '{}': its joints are {}", robot.name, name,
                              fmt::join(robot.joint_names, ", ")));
}

/// Returns the joints of NAME=FIRST..LAST, which has its equals sign at index `equals`.
std::vector<int> joint_range(const RobotModel& robot, const std::string& selection,
                             std::size_t equals) {
  const std::size_t dots = selection.find("..", equals);
  if (equals == 0 || dots == std::string::npos)
    fail(selection, fmt::format("must be {}", kGroupHelp));
  if (selection.find('/') < equals) fail(selection, "a file name cannot contain '/'");
  const int first = find_joint(robot, selection, selection.substr(equals + 1, dots - equals - 1));
  const int last = find_joint(robot, selection, selection.substr(dots + 2));
  if (first > last) {
    fail(selection, fmt::format("'{}' comes after '{}': swap them", robot.joint_names[first],
                                robot.joint_names[last]));
  }
  std::vector<int> joints(last - first + 1);
  std::iota(joints.begin(), joints.end(), first);
  return joints;
}

/// Returns the frame nearest to the palm, among its ancestors, whose name ends with "flange"; the
/// palm if there is no such frame. A hand may have wrist joints of its own beyond the flange.
int flange_frame(const RobotModel& robot) {
  for (const int frame : robot::ancestors(robot, robot.palm_frame)) {
    if (robot.frames[frame].name.ends_with("flange")) return frame;
  }
  return robot.palm_frame;
}

std::vector<int> arm_or_hand_joints(const RobotModel& robot, const std::string& selection) {
  if (selection != "all" && selection != "arm" && selection != "hand")
    fail(selection, fmt::format("must be {}", kGroupHelp));
  const int flange = flange_frame(robot);
  std::vector<int> joints;
  for (int joint = 0; joint < std::ssize(robot.joint_names); ++joint) {
    const bool arm = robot::joint_moves_frame(robot, joint, flange);
    if (selection == "all" || arm == (selection == "arm")) joints.push_back(joint);
  }
  if (joints.empty()) {
    fail(selection, fmt::format("{} has no joints of {}: omit --group", robot.name,
                                selection == "arm" ? "an arm" : "a hand"));
  }
  return joints;
}

}  // namespace

JointGroup joint_group(const RobotModel& robot, const std::string& selection) {
  const std::size_t equals = selection.find('=');
  JointGroup group{selection.substr(0, equals), {}, {}, {}};
  group.joints = equals == std::string::npos ? arm_or_hand_joints(robot, selection)
                                             : joint_range(robot, selection, equals);
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
