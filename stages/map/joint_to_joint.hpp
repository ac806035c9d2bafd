#pragma once

#include <vector>

#include "core/humanlike/frame_goal.hpp"
#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::map {

/// Joint-to-joint mapping, a baseline: the robot's joints take the angles of the human's, as far as
/// it has them; where the fingertips get to is left to the lengths of its links. In terms that hold
/// for any robot, whatever its zeros, signs and number of joints, every link points as the human's
/// does (posed_like.hpp): upper arm and forearm in the world, bones of the fingers in the palm's
/// frame, and the hand is turned as the human's. A hand without five fingers has the bones between
/// the human's (finger_curve.hpp).
///
/// Goals of the frames: `chain` of the arm, `hand`, and `angles` of the fingers' joints, those that
/// come nearest to the bones inside the joints' limits. No other goals. A finger whose angles were
/// not recorded in a frame has none there; one whose never were stays at zero (or the limit next to
/// it), and goals.estimated says "finger angles".
///
/// `angles` [N, 20] are the human's kHandAngleNames at `angle_time`, or have no rows.
std::vector<humanlike::FrameGoal> joint_to_joint_goals(const robot::Robot& robot,
                                                       const JointRows& angles,
                                                       const std::vector<double>& angle_time,
                                                       Goals& goals);

}  // namespace morphe::map
