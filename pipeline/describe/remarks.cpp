#include <fmt/format.h>

#include <algorithm>

#include "core/robot/tree.hpp"

#include "pipeline/describe/report.hpp"

namespace morphe::describe {
namespace {

const RobotTable::Frame& frame_at(const RobotTable& robot, int frame) {
  return robot.frames[static_cast<std::size_t>(frame)];
}

/// Whether a frame moves with all that moves another: fixed frames may lie side by side.
bool hangs_on_body(const RobotTable& robot, int frame, int other) {
  return robot::hangs_on(robot, frame, robot::body_of(robot, other));
}

bool moves_a_tip(const RobotTable& robot, int joint) {
  return std::ranges::any_of(robot.tips, [&](const RobotTable::Tip& tip) {
    return robot::moves(robot, joint, tip.frame);
  });
}

bool has_centre(const RobotTable& robot, const RobotTable::Tip& tip) {
  return std::ranges::any_of(robot.centres, [&](const RobotTable::Centre& centre) {
    return centre.chain != "arm" && robot::hangs_on(robot, tip.frame, centre.frame);
  });
}

}  // namespace

double stretched_reach(const RobotTable& robot, const RobotTable::Tip& tip) {
  const int shoulder = robot::body_of(robot, robot.shoulder_frame);
  double reach = tip.transform.translation().norm();
  for (const int frame : robot::upwards(robot, tip.frame)) {
    if (frame == shoulder) break;
    reach += frame_at(robot, frame).transform.translation().norm();
  }
  return reach;
}

std::vector<std::string> remarks(const robot::RobotDescription& description) {
  const RobotTable& robot = description.table;
  std::vector<std::string> found = description.notes;
  for (std::size_t k = 0; k < robot.joints(); ++k) {
    if (!moves_a_tip(robot, static_cast<int>(k))) {
      found.push_back(fmt::format("joint {} moves no tip", robot.joint_names[k]));
    }
  }
  if (!hangs_on_body(robot, robot.palm_frame, robot.shoulder_frame)) {
    found.push_back(fmt::format("palm {} does not hang on shoulder {}",
                                frame_at(robot, robot.palm_frame).name,
                                frame_at(robot, robot.shoulder_frame).name));
  }
  for (const RobotTable::Tip& tip : robot.tips) {
    if (tip.finger >= 0 && !hangs_on_body(robot, tip.frame, robot.palm_frame)) {
      found.push_back(fmt::format("tip {} does not hang on palm {}", tip.name,
                                  frame_at(robot, robot.palm_frame).name));
    }
    if (tip.finger >= 0 && !has_centre(robot, tip)) {
      found.push_back(fmt::format("tip {} has no centre for its finger's humanlikeness", tip.name));
    }
  }
  if (!robot.unchecked_links.empty()) found.push_back(unchecked_sentence(robot.unchecked_links));
  return found;
}

}  // namespace morphe::describe
