#include <fmt/format.h>

#include <algorithm>

#include "core/robot/tree.hpp"

#include "pipeline/describe/robot_text.hpp"

namespace morphe::describe {
namespace {

const RobotModel::Frame& frame_at(const RobotModel& robot, int frame) {
  return robot.frames[frame];
}

/// Returns true if a frame moves with all joints that move another one; frames fixed to the same
/// body may be siblings.
bool hangs_on_body(const RobotModel& robot, int frame, int other) {
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
    reach += frame_at(robot, frame).transform.translation().norm();
  }
  return reach;
}

std::vector<std::string> plausibility_notes(const robot::RobotDescription& description) {
  const RobotModel& robot = description.table;
  std::vector<std::string> found = description.notes;
  for (std::size_t k = 0; k < robot.joints(); ++k) {
    if (!moves_a_tip(robot, static_cast<int>(k))) {
      found.push_back(fmt::format("joint {} moves no tip", robot.joint_names[k]));
    }
  }
  if (!hangs_on_body(robot, robot.palm_frame, robot.shoulder_frame)) {
    found.push_back(fmt::format("palm {} is not moved by the shoulder {}",
                                frame_at(robot, robot.palm_frame).name,
                                frame_at(robot, robot.shoulder_frame).name));
  }
  for (const RobotModel::Tip& tip : robot.tips) {
    if (tip.finger >= 0 && !hangs_on_body(robot, tip.frame, robot.palm_frame)) {
      found.push_back(fmt::format("tip {} is not on the palm {}", tip.name,
                                  frame_at(robot, robot.palm_frame).name));
    }
    if (tip.finger >= 0 && !has_centre(robot, tip)) {
      found.push_back(
          fmt::format("tip {} has no joint centre for the humanlikeness of its finger", tip.name));
    }
  }
  if (!robot.unchecked_links.empty()) found.push_back(unchecked_sentence(robot.unchecked_links));
  return found;
}

}  // namespace morphe::describe
