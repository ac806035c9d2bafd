#include <fmt/format.h>

#include <algorithm>

#include "core/robot/tree.hpp"
#include "pipeline/describe/robot_text.hpp"

namespace morphe::describe {
namespace {

/// Returns true if all joints that move the frame `other` also move `frame`.
bool moves_with(const RobotModel& robot, int frame, int other) {
  return robot::is_in_subtree(robot, frame, robot::moving_frame_of(robot, other));
}

bool moves_a_tip(const RobotModel& robot, int joint) {
  return std::ranges::any_of(robot.tips, [&](const RobotModel::Tip& tip) {
    return robot::joint_moves_frame(robot, joint, tip.frame);
  });
}

bool has_centre(const RobotModel& robot, const RobotModel::Tip& tip) {
  return std::ranges::any_of(robot.joint_centres, [&](const RobotModel::JointCentre& centre) {
    return centre.chain != "arm" && robot::is_in_subtree(robot, tip.frame, centre.frame);
  });
}

}  // namespace

double stretched_reach(const RobotModel& robot, const RobotModel::Tip& tip) {
  const int shoulder = robot::moving_frame_of(robot, robot.shoulder_frame);
  double reach = tip.transform.translation().norm();
  for (const int frame : robot::ancestors(robot, tip.frame)) {
    if (frame == shoulder) break;
    reach += robot.frames[frame].transform.translation().norm();
  }
  return reach;
}

std::vector<std::string> plausibility_notes(const robot::RobotDescription& description) {
  const RobotModel& robot = description.table;
  const std::string& palm = robot.frames[robot.palm_frame].name;
  std::vector<std::string> notes = description.notes;
  for (int k = 0; k < std::ssize(robot.joint_names); ++k)
    if (!moves_a_tip(robot, k))
      notes.push_back(fmt::format("joint {} moves no tip", robot.joint_names[k]));
  if (!moves_with(robot, robot.palm_frame, robot.shoulder_frame))
    notes.push_back(fmt::format("palm {} is not moved by the shoulder {}", palm,
                                robot.frames[robot.shoulder_frame].name));
  for (const RobotModel::Tip& tip : robot.tips) {
    if (tip.finger >= 0 && !moves_with(robot, tip.frame, robot.palm_frame))
      notes.push_back(fmt::format("tip {} is not on the palm {}", tip.name, palm));
    if (tip.finger >= 0 && !has_centre(robot, tip))
      notes.push_back(
          fmt::format("tip {} has no joint centre for the humanlikeness of its finger", tip.name));
  }
  if (!robot.unchecked_links.empty()) notes.push_back(unchecked_sentence(robot.unchecked_links));
  return notes;
}

}  // namespace morphe::describe
