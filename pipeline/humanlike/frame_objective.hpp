#pragma once

#include "pipeline/humanlike/terms.hpp"

namespace morphe::humanlike {

/// The paper's arm-hand objective of one frame, Eq. (16), with metric A (and B, C where weighted):
///   w_x sum ‖x_i - goal_i‖² + w_o sum d_o + w_A A + w_a sum A_i  (+ hand orientation, posture,
/// and what joint-to-joint has in their place).
struct FrameObjective {
  TipPosition tip_position;
  TipOrientation tip_orientation;
  HandOrientation hand_orientation;
  JointDistance joint_distance;
  FingerJointDistance finger_joint_distance;
  TriangleArea triangle_area;
  HullVolume hull_volume;
  NaturalPosture posture;
  ChainPosition chain_position;
  JointAngle joint_angle;
  FreeOffset offset;

  /// Variables of a frame: the robot's joints, and three more with a free offset.
  Eigen::Index variables(const RobotTable& robot) const {
    return static_cast<Eigen::Index>(robot.joints()) + (offset.free ? 3 : 0);
  }
};

/// What evaluations of one descent share; a new descent begins with new_descent().
struct ObjectiveScratch {
  std::vector<Pose> base_from_frame;  ///< the frames' poses at the last q
  Loads loads;
  LoadSweep sweep;
  JointVector last;  ///< q of the last exact evaluation

  void new_descent() { loads.forget(); }
};

/// Adds every term at q [variables] to the model; with Curvature::none the Hessian stays as it is
/// (posture and offset, which are quadratic, add theirs in any case).
void add_objective(const FrameObjective& objective, const RobotTable& robot, const JointVector& q,
                   const FrameGoal& goal, ObjectiveScratch& scratch, solve::Quadratic& model,
                   Curvature curvature = Curvature::gauss_newton);

}  // namespace morphe::humanlike
