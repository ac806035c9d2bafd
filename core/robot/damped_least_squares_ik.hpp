#pragma once

#include <vector>

#include "core/robot/robot.hpp"

namespace morphe::robot {

/// Buffers of damped_least_squares_ik.
struct IkScratch {
  std::vector<Pose> base_from_frame;
  Eigen::MatrixXd tip_jacobian, jacobian, normal_matrix;
  Eigen::VectorXd error;
  JointVector step;
};

/// Moves the tips from the nearby posture q to their places by damped least squares,
///   q += Jᵀ (J Jᵀ + λ I)⁻¹ (place - tip)
/// within the joint limits, with little more motion than needed. `places` [tips] are in the base
/// frame [m]; a tip whose place is NaN is free. tip_to_pad_share [tips] selects the point of each
/// tip that is moved (tracked_point); if it is empty, this is the tip itself. The iteration ends
/// after `steps` steps, or when every tip is within tolerance_m of its place. Returns the largest
/// remaining distance [m].
double damped_least_squares_ik(const Robot& robot, const std::vector<Vec3>& places,
                               const std::vector<double>& tip_to_pad_share, int steps,
                               double tolerance_m, JointVector& q, IkScratch& scratch);

}  // namespace morphe::robot
