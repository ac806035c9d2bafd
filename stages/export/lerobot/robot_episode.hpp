#pragma once

#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/export/lerobot/episode.hpp"

namespace morphe::exports {

/// The features that a plan has only if it has an object or contacts. A dataset has those that all
/// of its plans have.
struct OptionalFeatures {
  bool target = true;    ///< pose of the object that is grasped
  bool contacts = true;  ///< contacts were planned
};
/// Returns the optional features that a plan has.
OptionalFeatures optional_features(const Plan& plan);

/// Returns the features of a robot, poses in its base frame [m], quaternions w, x, y, z:
///   observation.state, observation.velocity [n]    joints, <joint>.pos and <joint>.vel
///   observation.palm [7], observation.tips [3 m]
///   observation.environment_state [7]              pose of the target, which the hand carries
///   observation.contact [m]                        1: the tip's pad touches the target
///   action [n]                                     positions of the joints at the next frame
///   phase                                          index of the PhaseKind
std::vector<Feature> robot_features(const RobotModel& robot, const OptionalFeatures& optional);

/// The motion of a plan at the times of the frames.
struct EpisodeMotion {
  Trajectory frames;
  double grasp_s = kInfinity;  ///< time of the grasp in the motion
  double end_s = kInfinity;    ///< end of the plan's trajectory in it; after it the hand retreats
};

/// Returns a plan as an episode with these features. The last action is the last position.
Episode robot_episode(const RobotModel& robot, const Plan& plan, const EpisodeMotion& motion,
                      const OptionalFeatures& optional);

/// Returns the task of a plan in words: "drink: take cup with the right hand".
std::string task_sentence(const Plan& plan);

}  // namespace morphe::exports
