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

std::size_t joint_called(const RobotTable& robot, const std::string& asked,
                         const std::string& name) {
  const auto found = std::ranges::find(robot.joint_names, name);
  if (found == robot.joint_names.end()) {
    fail(asked, fmt::format("{} has no joint '{}': its joints are {}", robot.name, name,
                            fmt::join(robot.joint_names, ", ")));
  }
  return static_cast<std::size_t>(found - robot.joint_names.begin());
}

/// Of NAME=FIRST..LAST.
std::vector<int> from_to(const RobotTable& robot, const std::string& asked, std::size_t equals) {
  const std::size_t dots = asked.find("..", equals);
  if (equals == 0 || dots == std::string::npos) {
    fail(asked, fmt::format("must be {}", kGroupHelp));
  }
  if (asked.find('/') < equals) fail(asked, "a name of files cannot hold '/'");
  const std::size_t first = joint_called(robot, asked, asked.substr(equals + 1, dots - equals - 1));
  const std::size_t last = joint_called(robot, asked, asked.substr(dots + 2));
  if (first > last) {
    fail(asked, fmt::format("'{}' comes after '{}': change places", robot.joint_names[first],
                            robot.joint_names[last]));
  }
  std::vector<int> joints;
  for (std::size_t j = first; j <= last; ++j) joints.push_back(static_cast<int>(j));
  return joints;
}

/// Where the arm ends: the last frame on the way to the palm that is called a flange; beyond it a
/// hand's own wrist may turn the palm. The palm where there is none.
int end_of_arm(const RobotTable& robot) {
  for (const int frame : robot::upwards(robot, robot.palm_frame)) {
    if (robot.frames[static_cast<std::size_t>(frame)].name.ends_with("flange")) return frame;
  }
  return robot.palm_frame;
}

std::vector<int> of_kind(const RobotTable& robot, const std::string& asked) {
  if (asked != "all" && asked != "arm" && asked != "hand") {
    fail(asked, fmt::format("must be {}", kGroupHelp));
  }
  const int end = end_of_arm(robot);
  std::vector<int> joints;
  for (int joint = 0; joint < static_cast<int>(robot.joints()); ++joint) {
    const bool arm = robot::moves(robot, joint, end);
    if (asked == "all" || arm == (asked == "arm")) joints.push_back(joint);
  }
  if (joints.empty()) {
    fail(asked, fmt::format("{} has no joints of {}: leave --group out", robot.name,
                            asked == "arm" ? "an arm" : "a hand"));
  }
  return joints;
}

}  // namespace

JointGroup joint_group(const RobotTable& robot, const std::string& asked) {
  const std::size_t equals = asked.find('=');
  const bool own = equals != std::string::npos;
  JointGroup group{asked.substr(0, equals), {}, {}, {}};
  group.joints = own ? from_to(robot, asked, equals) : of_kind(robot, asked);
  for (const int joint : group.joints) {
    group.names.push_back(robot.joint_names[static_cast<std::size_t>(joint)]);
    group.units.push_back(robot::slides(robot, joint) ? "m" : "rad");
  }
  return group;
}

Trajectory of_group(const Trajectory& trajectory, const JointGroup& group) {
  Trajectory part = trajectory;
  for (JointRows Trajectory::*rows :
       {&Trajectory::position, &Trajectory::velocity, &Trajectory::acceleration}) {
    part.*rows = (trajectory.*rows)(Eigen::all, group.joints).eval();
  }
  return part;
}

}  // namespace morphe::exports
