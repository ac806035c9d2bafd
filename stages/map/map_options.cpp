#include "stages/map/map_options.hpp"

#include <algorithm>

#include "core/motion/input_error.hpp"
#include "core/robot/tree.hpp"

namespace morphe::map {
namespace {

int joint_index(const RobotModel& robot, const std::string& name) {
  const auto found = std::find(robot.joint_names.begin(), robot.joint_names.end(), name);
  if (found == robot.joint_names.end()) {
    throw InputError("map.natural_posture: robot " + robot.name + " has no actuated joint '" +
                     name + "'");
  }
  return static_cast<int>(found - robot.joint_names.begin());
}

std::vector<int> tips_moved_by(const RobotModel& robot, int joint) {
  std::vector<int> tips;
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    if (robot::joint_moves_frame(robot, joint, robot.tips[tip].frame))
      tips.push_back(static_cast<int>(tip));
  }
  return tips;
}

/// Removes or replaces the terms of the objective as required by a mode.
void set_mode(MapMode mode, humanlike::FrameObjective& objective) {
  using humanlike::TermGroup;
  if (mode == MapMode::humanlike) return;
  objective.for_each_term([&]<class T>(T& term) {
    const bool humanlike =
        T::kGroup == TermGroup::humanlike_arm || T::kGroup == TermGroup::humanlike_fingers;
    const bool turns = T::kGroup == TermGroup::tip_orientation;
    if (humanlike || (turns && mode == MapMode::fingertip_only)) term.weight = 0;
  });
  if (mode == MapMode::joint_to_joint) {
    // Length of a finger [m], which converts angles to displacements.
    constexpr double kFingerLever_m = 0.1;
    const double weight = objective.get<humanlike::TipPosition>().weight;
    objective.get<humanlike::ChainPosition>().weight = weight;
    objective.get<humanlike::JointAngle>().weight = kFingerLever_m * kFingerLever_m * weight;
    // Reached exactly if possible: the angle is not squared.
    objective.get<humanlike::HandOrientation>().weight = 1;
  }
}

}  // namespace

std::string validation_error(const BaseOffset& o) {
  if (!(o.limit_m >= 0 && o.weight >= 0)) return "limit and weight must not be negative";
  return "";
}

std::string validation_error(const MapOptions& o) {
  double least =
      std::min({o.movement_cost.velocity, o.movement_cost.acceleration, o.movement_cost.jerk});
  o.objective.for_each_term([&](const auto& term) { least = std::min(least, term.weight); });
  if (least < 0) return "weights must not be negative";
  const auto& thumb = o.objective.get<humanlike::ThumbDistance>();
  if (!(thumb.full_distance_m >= 0 && thumb.full_distance_m < thumb.zero_distance_m)) {
    return "thumb_full_distance must not be negative, and less than thumb_zero_distance";
  }
  if (const std::string wrong = validation_error(o.phases); !wrong.empty())
    return "phases: " + wrong;
  if (o.phase_blend_s < 0) return "phase_blend_s must not be negative";
  if (o.orientation_smoothing <= 0) return "orientation_smoothing must be positive";
  if (o.key_frames < 1 || o.starts < 1 || o.candidates < 1) {
    return "key_frames, starts and candidates must be at least 1";
  }
  if (o.coarse_step_s <= 0) return "coarse_step_s must be positive";
  if (o.reach_search_starts < 1 || o.reach_tolerance_m <= 0) {
    return "reach_search_starts and reach_tolerance_m must be positive";
  }
  return "";
}

humanlike::FrameObjective make_objective(const MapOptions& options, const RobotModel& robot) {
  humanlike::FrameObjective objective = options.objective;
  objective.get<humanlike::TipOrientation>().smoothing_rad = options.orientation_smoothing;
  objective.get<humanlike::HandOrientation>().smoothing_rad = options.orientation_smoothing;
  for (const NaturalJoint& natural : options.natural_posture) {
    humanlike::NaturalPosture::Joint entry;
    entry.joint = joint_index(robot, natural.joint);
    entry.follow = natural.follow.empty() ? -1 : joint_index(robot, natural.follow);
    entry.value = natural.value;
    entry.tips = tips_moved_by(robot, entry.joint);
    objective.get<humanlike::NaturalPosture>().joints.push_back(std::move(entry));
  }
  set_mode(options.mode, objective);
  return objective;
}

}  // namespace morphe::map
