#include "core/math/rigid.hpp"

#include <Eigen/SVD>
#include <cassert>
#include <cmath>

namespace morphe::math {

Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& m) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(m, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d sign = Eigen::Matrix3d::Identity();
  sign(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  return svd.matrixU() * sign * svd.matrixV().transpose();
}

namespace {

constexpr double kCollinearTolerance_m = 0.002;

/// Returns true if points with this spread are nearly on a line: its second singular value, s1, is
/// below the square of the tolerance. It is not if the sum of the principal minors, which is at
/// most 3 s0 s1, is above 3 times that and the trace; this takes no decomposition.
bool is_collinear(const Eigen::Matrix3d& spread) {
  constexpr double kSquare_m2 = kCollinearTolerance_m * kCollinearTolerance_m, kRounding = 1e-12;
  const double minors = spread(0, 0) * spread(1, 1) - spread(0, 1) * spread(1, 0) +
                        spread(0, 0) * spread(2, 2) - spread(0, 2) * spread(2, 0) +
                        spread(1, 1) * spread(2, 2) - spread(1, 2) * spread(2, 1);
  const double trace = spread.trace();
  if (minors > 3 * trace * kSquare_m2 + kRounding * trace * trace) return false;
  return spread.jacobiSvd().singularValues()[1] < kSquare_m2;
}

}  // namespace

Pose fit_rigid_transform(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
  assert(from.size() == to.size());
  Vec3 from_mean = Vec3::Zero(), to_mean = Vec3::Zero();
  int pairs = 0;
  for (std::size_t k = 0; k < from.size(); ++k) {
    if (!is_known(from[k]) || !is_known(to[k])) continue;
    from_mean += from[k];
    to_mean += to[k];
    ++pairs;
  }
  if (pairs < 3) return unseen_pose();
  from_mean /= pairs;
  to_mean /= pairs;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(), spread = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < from.size(); ++k) {
    if (!is_known(from[k]) || !is_known(to[k])) continue;
    const Vec3 a = from[k] - from_mean;
    covariance += (to[k] - to_mean) * a.transpose();
    spread += a * a.transpose();
  }
  if (is_collinear(spread)) return unseen_pose();
  Pose pose = Pose::Identity();
  pose.linear() = nearest_rotation(covariance);
  pose.translation() = to_mean - pose.linear() * from_mean;
  return pose;
}

double rigid_residual(const Pose& to_from, const std::vector<Vec3>& from,
                      const std::vector<Vec3>& to) {
  double sum = 0;
  int pairs = 0;
  for (std::size_t k = 0; k < from.size(); ++k) {
    if (!is_known(from[k]) || !is_known(to[k])) continue;
    sum += (to_from * from[k] - to[k]).squaredNorm();
    ++pairs;
  }
  return pairs == 0 ? kUnknown : std::sqrt(sum / pairs);
}

}  // namespace morphe::math
