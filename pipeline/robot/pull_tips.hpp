#pragma once

#include <vector>

#include "pipeline/motion/robot_table.hpp"

namespace morphe::robot {

/// To be reused.
struct PullScratch {
  std::vector<Pose> base_from_frame;
  Eigen::MatrixXd of_tips, jacobian, normal;
  Eigen::VectorXd error;
  JointVector step;
};

/// Inverse kinematics of tip positions from a posture near by: damped least squares
///   q += Jᵀ (J Jᵀ + λ I)⁻¹ (place - tip)
/// inside the joint limits, which draws the tips to their places with hardly more motion than that
/// takes, or as near as `steps` steps come. places [m] in the base frame; NaN: the tip is free.
/// Ends where every tip is within `near_m`. The largest distance left [m].
double pull_tips(const RobotTable& robot, const std::vector<Vec3>& places, int steps, double near_m,
                 JointVector& q, PullScratch& scratch);

}  // namespace morphe::robot
