#pragma once

#include <vector>

#include "core/robot/robot.hpp"

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
/// pad_share [m] of what is to be there (goal_point), or empty: the tips.
double pull_tips(const Robot& robot, const std::vector<Vec3>& places,
                 const std::vector<double>& pad_share, int steps, double near_m, JointVector& q,
                 PullScratch& scratch);

}  // namespace morphe::robot
