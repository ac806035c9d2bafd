#include "pipeline/robot/pull_tips.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "pipeline/robot/forward.hpp"

namespace morphe::robot {
namespace {

using Eigen::Index;

/// Fills place - tip, 0 for free tips; the largest distance.
double measure(const RobotTable& robot, const std::vector<Vec3>& places, const JointVector& q,
               PullScratch& scratch) {
  forward(robot, q, scratch.base_from_frame);
  double largest = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    auto error = scratch.error.segment<3>(3 * static_cast<Index>(i));
    error.setZero();
    if (!seen(places[i])) continue;
    error = places[i] - tip_pose(robot, scratch.base_from_frame, i).translation();
    largest = std::max(largest, error.norm());
  }
  return largest;
}

void fill_jacobian(const RobotTable& robot, const std::vector<Vec3>& places, PullScratch& scratch) {
  tip_jacobians(robot, scratch.base_from_frame, scratch.of_tips);
  for (std::size_t i = 0; i < places.size(); ++i) {
    auto rows = scratch.jacobian.middleRows<3>(3 * static_cast<Index>(i));
    if (seen(places[i])) {
      rows = scratch.of_tips.middleRows<3>(6 * static_cast<Index>(i));
    } else {
      rows.setZero();
    }
  }
}

/// The step with the joints that it would take beyond their limits left where they are.
void find_step(const RobotTable& robot, const JointVector& q, PullScratch& scratch) {
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

double pull_tips(const RobotTable& robot, const std::vector<Vec3>& places, int steps, double near_m,
                 JointVector& q, PullScratch& scratch) {
  constexpr double kLongest = 0.3;  // of any joint [rad]
  const auto tips = static_cast<Index>(places.size());
  scratch.error.resize(3 * tips);
  scratch.of_tips.resize(6 * tips, q.size());
  scratch.jacobian.resize(3 * tips, q.size());
  double left = measure(robot, places, q, scratch);
  for (int k = 0; k < steps && left > near_m; ++k) {
    fill_jacobian(robot, places, scratch);
    find_step(robot, q, scratch);
    const double longest = scratch.step.cwiseAbs().maxCoeff();
    if (longest > kLongest) scratch.step *= kLongest / longest;
    q = (q + scratch.step).cwiseMax(robot.lower).cwiseMin(robot.upper);
    left = measure(robot, places, q, scratch);
  }
  return left;
}

}  // namespace morphe::robot
