#include "core/robot/pull_tips.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "core/robot/forward.hpp"

namespace morphe::robot {
namespace {

using Eigen::Index;

double share_of(const std::vector<double>& pad_share, std::size_t tip) {
  return pad_share.empty() ? 0 : pad_share[tip];
}

/// Fills place - tip, 0 for free tips; the largest distance.
double measure(const Robot& robot, const std::vector<Vec3>& places,
               const std::vector<double>& pad_share, const JointVector& q, PullScratch& scratch) {
  forward(robot, q, scratch.base_from_frame);
  double largest = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    auto error = scratch.error.segment<3>(3 * static_cast<Index>(i));
    error.setZero();
    if (!seen(places[i])) continue;
    error = places[i] - goal_point(robot, scratch.base_from_frame, i, share_of(pad_share, i));
    largest = std::max(largest, error.norm());
  }
  return largest;
}

void fill_jacobian(const Robot& robot, const std::vector<Vec3>& places,
                   const std::vector<double>& pad_share, PullScratch& scratch) {
  tip_jacobians(robot, scratch.base_from_frame, scratch.of_tips);
  for (std::size_t i = 0; i < places.size(); ++i) {
    auto rows = scratch.jacobian.middleRows<3>(3 * static_cast<Index>(i));
    if (!seen(places[i])) {
      rows.setZero();
      continue;
    }
    const Index of_tip = 6 * static_cast<Index>(i);
    rows = scratch.of_tips.middleRows<3>(of_tip);
    const double share = share_of(pad_share, i);
    if (share == 0) continue;
    const Vec3 beside = goal_point(robot, scratch.base_from_frame, i, share) -
                        goal_point(robot, scratch.base_from_frame, i, 0);
    for (Index j = 0; j < rows.cols(); ++j) {
      rows.col(j) += Vec3(scratch.of_tips.col(j).segment<3>(of_tip + 3)).cross(beside);
    }
  }
}

/// The step with the joints that it would take beyond their limits left where they are.
void find_step(const Robot& robot, const JointVector& q, PullScratch& scratch) {
  constexpr double kDamping = 1e-7;  // λ [m²]
  for (bool stopped = true; stopped;) {
    scratch.normal.noalias() = scratch.jacobian * scratch.jacobian.transpose();
    scratch.normal.diagonal().array() += kDamping;
    scratch.step.noalias() =
        scratch.jacobian.transpose() * scratch.normal.llt().solve(scratch.error);
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

double pull_tips(const Robot& robot, const std::vector<Vec3>& places,
                 const std::vector<double>& pad_share, int steps, double near_m, JointVector& q,
                 PullScratch& scratch) {
  constexpr double kLongest = 0.3;  // of any joint [rad]
  const auto tips = static_cast<Index>(places.size());
  scratch.error.resize(3 * tips);
  scratch.of_tips.resize(6 * tips, q.size());
  scratch.jacobian.resize(3 * tips, q.size());
  double left = measure(robot, places, pad_share, q, scratch);
  for (int k = 0; k < steps && left > near_m; ++k) {
    fill_jacobian(robot, places, pad_share, scratch);
    find_step(robot, q, scratch);
    const double longest = scratch.step.cwiseAbs().maxCoeff();
    if (longest > kLongest) scratch.step *= kLongest / longest;
    q = (q + scratch.step).cwiseMax(robot.lower).cwiseMin(robot.upper);
    left = measure(robot, places, pad_share, q, scratch);
  }
  return left;
}

}  // namespace morphe::robot
