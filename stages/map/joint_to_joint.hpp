#pragma once

#include <vector>

#include "core/humanlike/frame_goal.hpp"
#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::map {

/// Computes the goals of joint-to-joint mapping, a baseline in which the robot's joints take the
/// angles of the human's as far as it has them, and the positions of the fingertips follow from the
/// lengths of its links. So that it applies to any robot, regardless of its zeros, signs and number
/// of joints, every link points as the human's does (match_link_directions.hpp): upper arm and
/// forearm in the world, bones of the fingers in the palm's frame, and the hand has the human's
/// orientation. A hand without five fingers takes bones interpolated between the human's
/// (finger_curve.hpp).
///
/// The goals of the frames are `chain` of the arm, `hand`, and `angles` of the fingers' joints,
/// those that come nearest to the bones inside the joints' limits. There are no other goals. A
/// finger whose angles were not recorded in a frame has no goal there; one whose angles were never
/// recorded stays at zero (or the limit next to it), and goals.estimated says "finger angles".
///
/// `angles` [N, 20] are the human's kHandAngleNames at `angle_time`, or have no rows.
std::vector<humanlike::FrameGoal> joint_to_joint_goals(const robot::Robot& robot,
                                                       const JointRows& angles,
                                                       const std::vector<double>& angle_time,
                                                       Goals& goals);

}  // namespace morphe::map
