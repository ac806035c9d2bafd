#pragma once

#include "pipeline/humanlike/terms.hpp"

namespace morphe {

/// The paper's arm-hand objective of one frame, Eq. (16), with metric A:
///   w_x sum ‖x_i - goal_i‖² + w_o sum d_o + w_A A + w_a sum A_i  (+ hand orientation, posture).
struct FrameObjective {
  TipPosition tip_position;
  TipOrientation tip_orientation;
  HandOrientation hand_orientation;
  JointDistance joint_distance;
  FingerJointDistance finger_joint_distance;
  NaturalPosture posture;
};

/// Adds every term at q to the model; `base_from_frame` is scratch and holds the frames' poses at q
/// afterwards.
void add_objective(const FrameObjective& objective, const RobotTable& robot, const JointVector& q,
                   const FrameGoal& goal, std::vector<Pose>& base_from_frame, Quadratic& model);

}  // namespace morphe
