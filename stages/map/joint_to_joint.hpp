#pragma once

#include <vector>

#include "core/humanlike/frame_goal.hpp"
#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::map {

/// Computes the goals of joint-to-joint mapping, a baseline in which the robot's joints take the
/// human's angles, and the positions of the fingertips follow from the lengths of its links. So
/// that this applies to any robot, regardless of its zeros, signs and number of joints, every link
/// points as the human's does (match_link_directions.hpp): upper arm and forearm in the world,
/// bones of the fingers in the palm's frame (a hand without five fingers takes bones interpolated
/// between the human's, finger_curve.hpp); and the hand has the human's orientation.
///
/// A frame's only goals are `chain` of the arm, `hand`, and `angles` of the fingers' joints: those
/// inside the limits that come nearest to the bones. A finger has no goal in a frame without its
/// angles. A finger whose angles were never recorded stays at zero (or at the limit next to it),
/// and goals.estimated gets "finger angles". `angles` [N, 20] are the human's kHandAngleNames at
/// the ascending times `angle_time` [N]; N may be 0.
std::vector<humanlike::FrameGoal> joint_to_joint_goals(const robot::Robot& robot,
                                                       const JointRows& angles,
                                                       const std::vector<double>& angle_time,
                                                       Goals& goals);

}  // namespace morphe::map
