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
  // The unknowns are c_a - p_a and c_b - p_b. The sums over the frames of JᵀJ, -Jᵀb and bᵀb are
  // accumulated, with J = (R_a, -R_b) and b the step between the priors in the world.
  Eigen::Matrix3d rotation_sum = Eigen::Matrix3d::Zero();
  Vector6 right_side = Vector6::Zero();
  double squared_step = 0, frames = 0;
  for (int i = 0; i < std::ssize(world_from_a); ++i) {
    const Pose &a = world_from_a[i], &b = world_from_b[i];
    const Vec3 step = a * prior.in_a - b * prior.in_b;
    if (!is_known(step)) continue;
    rotation_sum += a.linear().transpose() * b.linear();
    right_side.head<3>() -= a.linear().transpose() * step;
    right_side.tail<3>() += b.linear().transpose() * step;
    squared_step += step.squaredNorm();
    ++frames;
  }
  if (frames == 0) return {unknown_point(), unknown_point(), kUnknown, kUnknown};
  Matrix6 normal = Matrix6::Identity();
  normal.topRightCorner<3, 3>() = -rotation_sum / frames;
  normal.bottomLeftCorner<3, 3>() = -rotation_sum.transpose() / frames;
  right_side /= frames;
  squared_step /= frames;

  constexpr int kMaxRounds = 30;
  constexpr double kMinResidual_m = 1e-5;
  Vector6 offset = Vector6::Zero();
  double residual = std::sqrt(squared_step), weight = 0;
  for (int round = 0; round < kMaxRounds; ++round) {
    weight = std::pow(std::max(residual, kMinResidual_m) / prior.sd_m, 2);
    offset = (normal + weight * Matrix6::Identity()).ldlt().solve(right_side);
    residual = std::sqrt(
        std::max(0.0, offset.dot(normal * offset) - 2 * offset.dot(right_side) + squared_step));
  }
  // The eigenvalues of [1 -T; -Tᵀ 1] are 1 ± the roots of those of TᵀT.
  const Eigen::Matrix3d coupling = rotation_sum / frames;
  const double max_moment = math::principal_axes(coupling.transpose() * coupling).moments[2];
  const double min_eigenvalue = 1 - std::sqrt(std::max(0.0, max_moment));
  return {prior.in_a + offset.head<3>(), prior.in_b + offset.tail<3>(), residual,
          std::max(residual, kMinResidual_m) / std::sqrt(std::max(0.0, min_eigenvalue) + weight)};
}

}  // namespace morphe::reconstruct
