#include "stages/map/map_options.hpp"

#include <algorithm>

#include "pipeline/motion/input_error.hpp"

namespace morphe {
namespace {

int joint_index(const RobotTable& robot, const std::string& name) {
  const auto found = std::find(robot.joint_names.begin(), robot.joint_names.end(), name);
  if (found == robot.joint_names.end()) {
    throw InputError("map.natural: robot " + robot.name + " has no actuated joint '" + name + "'");
  }
  return static_cast<int>(found - robot.joint_names.begin());
}

/// Tips below any frame that the joint turns, directly or through a coupling.
std::vector<int> tips_moved_by(const RobotTable& robot, int joint) {
  std::vector<int> tips;
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    int frame = robot.tips[tip].frame;
    while (frame >= 0 && robot.frames[static_cast<std::size_t>(frame)].joint != joint) {
      frame = robot.frames[static_cast<std::size_t>(frame)].parent;
    }
    if (frame >= 0) tips.push_back(static_cast<int>(tip));
  }
  return tips;
}

}  // namespace

std::string check(const MapOptions& o) {
  const double weights[] = {o.tip_position,           o.tip_orientation,
                            o.hand_orientation,       o.humanlike_arm,
                            o.humanlike_fingers,      o.posture,
                            o.movement_cost.velocity, o.movement_cost.acceleration,
                            o.movement_cost.jerk};
  if (*std::min_element(std::begin(weights), std::end(weights)) < 0) {
    return "weights must not be negative";
  }
  if (const std::string wrong = check(o.phases); !wrong.empty()) return "phases: " + wrong;
  if (o.phase_blend_s < 0) return "phase_blend_s must not be negative";
  if (o.orientation_smoothing <= 0) return "orientation_smoothing must be positive";
  if (o.key_frames < 1 || o.starts < 1 || o.candidates < 1) {
    return "key_frames, starts and candidates must be at least 1";
  }
  if (o.coarse_step_s <= 0) return "coarse_step_s must be positive";
  if (o.reachable_starts < 1 || o.reachable_m <= 0) {
    return "reachable_starts and reachable_m must be positive";
  }
  return "";
}

FrameObjective make_objective(const MapOptions& options, const RobotTable& robot) {
  FrameObjective objective;
  objective.tip_position.weight = options.tip_position;
  objective.tip_orientation = {options.tip_orientation, options.orientation_smoothing};
  objective.hand_orientation = {options.hand_orientation, options.orientation_smoothing};
  objective.joint_distance.weight = options.humanlike_arm;
  objective.finger_joint_distance.weight = options.humanlike_fingers;
  objective.posture.weight = options.posture;
  for (const NaturalJoint& natural : options.natural) {
    NaturalPosture::Joint entry;
    entry.joint = joint_index(robot, natural.joint);
    entry.follow = natural.follow.empty() ? -1 : joint_index(robot, natural.follow);
    entry.value = natural.value;
    entry.tips = tips_moved_by(robot, entry.joint);
    objective.posture.joints.push_back(std::move(entry));
  }
  return objective;
}

}  // namespace morphe
