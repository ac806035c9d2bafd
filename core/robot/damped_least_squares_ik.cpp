#include "core/robot/damped_least_squares_ik.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "core/robot/forward_kinematics.hpp"

namespace morphe::robot {
namespace {

using Eigen::Index;

double share_of(const std::vector<double>& tip_to_pad_share, std::size_t tip) {
  return tip_to_pad_share.empty() ? 0 : tip_to_pad_share[tip];
}

/// Fills the position errors place - tip, 0 for free tips, and returns the largest distance.
double fill_position_errors(const Robot& robot, const std::vector<Vec3>& places,
                            const std::vector<double>& tip_to_pad_share, const JointVector& q,
                            IkScratch& scratch) {
  forward_kinematics(robot, q, scratch.base_from_frame);
  double largest = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    auto error = scratch.error.segment<3>(3 * static_cast<Index>(i));
    error.setZero();
    if (!is_known(places[i])) continue;
    error =
        places[i] - tracked_point(robot, scratch.base_from_frame, i, share_of(tip_to_pad_share, i));
    largest = std::max(largest, error.norm());
  }
  return largest;
}

void fill_jacobian(const Robot& robot, const std::vector<Vec3>& places,
                   const std::vector<double>& tip_to_pad_share, IkScratch& scratch) {
  tip_jacobians(robot, scratch.base_from_frame, scratch.tip_jacobian);
  for (std::size_t i = 0; i < places.size(); ++i) {
    auto rows = scratch.jacobian.middleRows<3>(3 * static_cast<Index>(i));
    if (!is_known(places[i])) {
      rows.setZero();
      continue;
    }
    const Index of_tip = 6 * static_cast<Index>(i);
    rows = scratch.tip_jacobian.middleRows<3>(of_tip);
    const double share = share_of(tip_to_pad_share, i);
    if (share == 0) continue;
    const Vec3 beside = tracked_point(robot, scratch.base_from_frame, i, share) -
                        tracked_point(robot, scratch.base_from_frame, i, 0);
    for (Index j = 0; j < rows.cols(); ++j) {
      rows.col(j) += Vec3(scratch.tip_jacobian.col(j).segment<3>(of_tip + 3)).cross(beside);
    }
  }
}

/// Computes a step in which joints that would leave their limits do not move.
void find_step(const Robot& robot, const JointVector& q, IkScratch& scratch) {
  constexpr double kDamping_m2 = 1e-7;  // λ [m²]
  for (bool stopped = true; stopped;) {
    scratch.normal_matrix.noalias() = scratch.jacobian * scratch.jacobian.transpose();
    scratch.normal_matrix.diagonal().array() += kDamping_m2;
    scratch.step.noalias() =
        scratch.jacobian.transpose() * scratch.normal_matrix.llt().solve(scratch.error);
    stopped = false;
    for (Index j = 0; j < q.size(); ++j) {
      const bool outwards = (q[j] >= robot.upper[j] && scratch.step[j] > 0) ||
                            (q[j] <= robot.lower[j] && scratch.step[j] < 0);
      if (!outwards) continue;
      scratch.jacobian.col(j).setZero();
      stopped = true;
    }
  }
}

}  // namespace

double damped_least_squares_ik(const Robot& robot, const std::vector<Vec3>& places,
                               const std::vector<double>& tip_to_pad_share, int steps,
                               double near_m, JointVector& q, IkScratch& scratch) {
  // Largest step of any joint [rad].
  constexpr double kMaxJointStep_rad = 0.3;
  const auto tips = static_cast<Index>(places.size());
  scratch.error.resize(3 * tips);
  scratch.tip_jacobian.resize(6 * tips, q.size());
  scratch.jacobian.resize(3 * tips, q.size());
  double left = fill_position_errors(robot, places, tip_to_pad_share, q, scratch);
  for (int k = 0; k < steps && left > near_m; ++k) {
    fill_jacobian(robot, places, tip_to_pad_share, scratch);
    find_step(robot, q, scratch);
    const double longest = scratch.step.cwiseAbs().maxCoeff();
    if (longest > kMaxJointStep_rad) scratch.step *= kMaxJointStep_rad / longest;
    q = (q + scratch.step).cwiseMax(robot.lower).cwiseMin(robot.upper);
    left = fill_position_errors(robot, places, tip_to_pad_share, q, scratch);
  }
  return left;
}

}  // namespace morphe::robot
