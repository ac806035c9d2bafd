#include "stages/reconstruct/centre_of_rotation.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/math/rotation.hpp"

namespace morphe::reconstruct {

CentreOfRotation estimate_centre_of_rotation(const std::vector<Pose>& world_from_a,
                                             const std::vector<Pose>& world_from_b,
                                             const CentreOfRotationPrior& prior) {
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  // The unknowns are the distances of c_a and c_b from the prior. The means over the frames of J^T
  // J, -J^T b, b^T b are accumulated, with J = (R_a, -R_b) and b the step from one prior to the
  // other.
  Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();
  Vector6 right = Vector6::Zero();
  double apart = 0, frames = 0;
  for (std::size_t i = 0; i < world_from_a.size(); ++i) {
    const Pose &a = world_from_a[i], &b = world_from_b[i];
    const Vec3 step = a * prior.in_a - b * prior.in_b;
    if (!is_known(step)) continue;
    turn += a.linear().transpose() * b.linear();
    right.head<3>() -= a.linear().transpose() * step;
    right.tail<3>() += b.linear().transpose() * step;
    apart += step.squaredNorm();
    ++frames;
  }
  if (frames == 0) return {unknown_point(), unknown_point(), kUnknown, kUnknown};
  Matrix6 normal = Matrix6::Identity();
  normal.topRightCorner<3, 3>() = -turn / frames;
  normal.bottomLeftCorner<3, 3>() = -turn.transpose() / frames;
  right /= frames;
  apart /= frames;

  constexpr int kMaxRounds = 30;
  constexpr double kMinResidual_m = 1e-5;  // [m]
  Vector6 moved = Vector6::Zero();
  double residual = std::sqrt(apart), weight = 0;
  for (int round = 0; round < kMaxRounds; ++round) {
    weight = std::pow(std::max(residual, kMinResidual_m) / prior.sd_m, 2);
    moved = (normal + weight * Matrix6::Identity()).ldlt().solve(right);
    residual = std::sqrt(std::max(0.0, moved.dot(normal * moved) - 2 * moved.dot(right) + apart));
  }
  // The eigenvalues of [1 -T; -Tᵀ 1] are 1 ± the singular values of T, whose squares are those of
  // TᵀT.
  const Eigen::Matrix3d coupling = turn / frames;
  const double largest = math::principal_axes(coupling.transpose() * coupling).moments[2];
  const double least = 1 - std::sqrt(std::max(0.0, largest));
  return {prior.in_a + moved.head<3>(), prior.in_b + moved.tail<3>(), residual,
          std::max(residual, kMinResidual_m) / std::sqrt(std::max(0.0, least) + weight)};
}

}  // namespace morphe::reconstruct
