#include "stages/map/map_options.hpp"

#include <algorithm>

#include "core/motion/input_error.hpp"
#include "core/robot/tree.hpp"
#include "stages/map/constants.hpp"

namespace morphe::map {
namespace {

int joint_index(const RobotModel& robot, const std::string& name, const std::string& key) {
  for (int joint = 0; joint < std::ssize(robot.joint_names); ++joint) {
    if (robot.joint_names[joint] == name) return joint;
  }
  throw InputError("map." + key + ": robot " + robot.name + " has no actuated joint '" + name +
                   "'");
}

void set_mode(MapMode mode, humanlike::FrameObjective& objective) {
  using humanlike::TermGroup;
  if (mode == MapMode::humanlike) return;
  objective.for_each_term([&]<class T>(T& term) {
    const bool humanlike =
        T::kGroup == TermGroup::humanlike_arm || T::kGroup == TermGroup::humanlike_fingers;
    const bool orientation = T::kGroup == TermGroup::tip_orientation;
    if (humanlike || (orientation && mode == MapMode::fingertip_only)) term.weight = 0;
  });
  if (mode == MapMode::joint_to_joint) {
    const double weight = objective.get<humanlike::TipPosition>().weight;
    objective.get<humanlike::ChainPosition>().weight = weight;
    objective.get<humanlike::JointAngle>().weight = kFingerLength_m * kFingerLength_m * weight;
    // Any weight makes the solve meet this goal exactly if it can: its angle is not squared.
    objective.get<humanlike::HandOrientation>().weight = 1;
  }
}

}  // namespace

std::string validation_error(const MapOptions& o) {
  const auto& thumb = o.objective.get<humanlike::ThumbDistance>();
  if (!(thumb.full_distance_m < thumb.zero_distance_m))
    return "thumb_full_distance must be less than thumb_zero_distance";
  if (const auto error = validation_error(o.phases); !error.empty()) return "phases: " + error;
  return "";
}

humanlike::FrameObjective make_objective(const MapOptions& options, const RobotModel& robot) {
  humanlike::FrameObjective objective = options.objective;
  objective.get<humanlike::TipOrientation>().smoothing_rad = options.orientation_smoothing;
  objective.get<humanlike::HandOrientation>().smoothing_rad = options.orientation_smoothing;
  for (const NaturalJoint& natural : options.natural_posture) {
    humanlike::NaturalPosture::Joint entry;
    entry.joint = joint_index(robot, natural.joint, "natural_posture");
    entry.follow =
        natural.follow.empty() ? -1 : joint_index(robot, natural.follow, "natural_posture");
    entry.value = natural.value;
    for (int tip = 0; tip < std::ssize(robot.tips); ++tip) {
      const bool moves = robot::joint_moves_frame(robot, entry.joint, robot.tips[tip].frame);
      if (moves) entry.tips.push_back(tip);
    }
    objective.get<humanlike::NaturalPosture>().joints.push_back(std::move(entry));
  }
  set_mode(options.mode, objective);
  return objective;
}

JointVector branch_posture(const MapOptions& options, const RobotModel& robot) {
  JointVector posture = JointVector::Zero(robot.lower.size());
  for (const NaturalJoint& listed : options.branch_posture)
    posture[joint_index(robot, listed.joint, "branch_posture")] = listed.value;
  return posture.cwiseMax(robot.lower).cwiseMin(robot.upper);
}

}  // namespace morphe::map
