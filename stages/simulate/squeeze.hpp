#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"
#include "stages/simulate/servos.hpp"

namespace morphe::simulate {

/// One finger's part in a squeeze: it presses on the target at a point of its surface.
struct Press {
  std::size_t tip = 0;  ///< of the robot's table
  Vec3 point, inward;  ///< in the target's frame [m]; unit, into it, along which the finger presses
  double force_N = 0;
  Vec3 aside = Vec3::Zero();  ///< force beside it, in the target's frame [N]
};

/// How the hand takes hold.
struct Squeeze {
  std::vector<Press> presses;
  bool planned = false;  ///< the plan's
  JointVector closed;    ///< [n] the posture in which the fingers touch
  /// [n] how far beyond it the servos must aim for the forces: Jᵀ force / stiffness.
  JointVector beyond;
  /// What the joints' torques leave of the forces asked for, for all fingers alike, <= 1.
  double force_share = 1;
};

/// The plan's squeeze from the posture at which its trajectory ends: fingers go to where the plan
/// has them at the grasp, and aim beyond by its torques over the servos' stiffness, which is its
/// squeeze_posture where that is the stiffness it was made for. None if it has no squeeze, names
/// less than two contacts with forces, or holds numbers that are none.
std::optional<Squeeze> planned_squeeze(const robot::Robot& robot, const Plan& plan,
                                       const JointVector& posture,
                                       const std::vector<Servo>& servos);

/// For plans without a squeeze: from a posture at the target and a list of presses, closes their
/// fingers and computes where the servos must aim. Only joints that move a tip and not the palm
/// take part.
Squeeze squeeze_with(const robot::Robot& robot, const JointVector& posture,
                     const Pose& base_from_target, const SceneObject& target,
                     std::vector<Press> presses, const std::vector<Servo>& servos);

/// Of a plan without a squeeze: the thumb and every other finger that had a goal at the grasp
/// press where their last links are nearest to the target, once closed, straight into it: the thumb
/// with `force_N`, the others with equal shares of it. Empty, and why, without a thumb, another
/// finger or a capsule at their tips.
std::vector<Press> presses_of(const robot::Robot& robot, const Plan& plan,
                              const JointVector& posture, double force_N, std::string& why_none);

}  // namespace morphe::simulate
