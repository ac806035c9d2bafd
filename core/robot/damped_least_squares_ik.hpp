#pragma once

#include <vector>

#include "core/robot/robot.hpp"

namespace morphe::robot {

/// Buffers of damped_least_squares_ik, to be reused between calls.
struct IkScratch {
  std::vector<Pose> base_from_frame;
  Eigen::MatrixXd tip_jacobian, jacobian, normal_matrix;
  Eigen::VectorXd error;
  JointVector step;
};

/// Solves inverse kinematics of tip positions from a nearby posture by damped least squares,
///   q += Jᵀ (J Jᵀ + λ I)⁻¹ (place - tip)
/// within the joint limits. It moves the tips to their places with little more motion than needed,
/// or as close as `steps` iterations allow. places [m] are in the base frame; a tip whose place is
/// NaN is free. It stops as soon as every tip is within `near_m` of its place, and returns the
/// largest remaining distance [m]. tip_to_pad_share [m] selects the tracked point of each tip
/// (tracked_point); if it is empty, the tips themselves are tracked.
double damped_least_squares_ik(const Robot& robot, const std::vector<Vec3>& places,
                               const std::vector<double>& tip_to_pad_share, int steps,
                               double near_m, JointVector& q, IkScratch& scratch);

}  // namespace morphe::robot
