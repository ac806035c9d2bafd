#include "core/robot/damped_least_squares_ik.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "core/robot/forward_kinematics.hpp"

namespace morphe::robot {
namespace {

double share_of(const std::vector<double>& tip_to_pad_share, Eigen::Index tip) {
  return tip_to_pad_share.empty() ? 0 : tip_to_pad_share[tip];
}

/// Fills the position errors place - tip, 0 for free tips. Returns the largest distance [m].
double fill_position_errors(const Robot& robot, const std::vector<Vec3>& places,
                            const std::vector<double>& tip_to_pad_share, const JointVector& q,
                            IkScratch& scratch) {
  forward_kinematics(robot, q, scratch.base_from_frame);
  double max_distance = 0;
  for (Eigen::Index i = 0; i < std::ssize(places); ++i) {
    auto error = scratch.error.segment<3>(3 * i);
    error.setZero();
    if (!is_known(places[i])) continue;
    error =
        places[i] - tracked_point(robot, scratch.base_from_frame, i, share_of(tip_to_pad_share, i));
    max_distance = std::max(max_distance, error.norm());
  }
  return max_distance;
}

void fill_jacobian(const Robot& robot, const std::vector<Vec3>& places,
                   const std::vector<double>& tip_to_pad_share, IkScratch& scratch) {
  tip_jacobians(robot, scratch.base_from_frame, scratch.tip_jacobian);
  for (Eigen::Index i = 0; i < std::ssize(places); ++i) {
    auto rows = scratch.jacobian.middleRows<3>(3 * i);
    if (!is_known(places[i])) {
      rows.setZero();
      continue;
    }
    rows = scratch.tip_jacobian.middleRows<3>(6 * i);
    const double share = share_of(tip_to_pad_share, i);
    if (share == 0) continue;
    const Vec3 tip_to_point = tracked_point(robot, scratch.base_from_frame, i, share) -
                              tracked_point(robot, scratch.base_from_frame, i, 0);
    for (int j = 0; j < rows.cols(); ++j)
      rows.col(j) += Vec3(scratch.tip_jacobian.col(j).segment<3>(6 * i + 3)).cross(tip_to_point);
  }
}

/// Computes a step in which joints that would leave their limits do not move; their columns of the
/// Jacobian become zero.
void find_step(const Robot& robot, const JointVector& q, IkScratch& scratch) {
  constexpr double kDamping_m2 = 1e-7;  // λ [m²]
  for (bool joint_stopped = true; joint_stopped;) {
    scratch.normal_matrix.noalias() = scratch.jacobian * scratch.jacobian.transpose();
    scratch.normal_matrix.diagonal().array() += kDamping_m2;
    scratch.step.noalias() =
        scratch.jacobian.transpose() * scratch.normal_matrix.llt().solve(scratch.error);
    joint_stopped = false;
    for (int j = 0; j < q.size(); ++j) {
      const bool outwards = (q[j] >= robot.upper[j] && scratch.step[j] > 0) ||
                            (q[j] <= robot.lower[j] && scratch.step[j] < 0);
      if (!outwards) continue;
      scratch.jacobian.col(j).setZero();
      joint_stopped = true;
    }
  }
}

}  // namespace

double damped_least_squares_ik(const Robot& robot, const std::vector<Vec3>& places,
                               const std::vector<double>& tip_to_pad_share, int steps,
                               double tolerance_m, JointVector& q, IkScratch& scratch) {
  constexpr double kMaxJointStep_rad = 0.3;
  const std::ptrdiff_t tips = std::ssize(places);
  scratch.error.resize(3 * tips);
  scratch.tip_jacobian.resize(6 * tips, q.size());
  scratch.jacobian.resize(3 * tips, q.size());
  double error_m = fill_position_errors(robot, places, tip_to_pad_share, q, scratch);
  for (int k = 0; k < steps && error_m > tolerance_m; ++k) {
    fill_jacobian(robot, places, tip_to_pad_share, scratch);
    find_step(robot, q, scratch);
    const double max_change = scratch.step.cwiseAbs().maxCoeff();
    if (max_change > kMaxJointStep_rad) scratch.step *= kMaxJointStep_rad / max_change;
    q = (q + scratch.step).cwiseMax(robot.lower).cwiseMin(robot.upper);
    error_m = fill_position_errors(robot, places, tip_to_pad_share, q, scratch);
  }
  return error_m;
}

}  // namespace morphe::robot
