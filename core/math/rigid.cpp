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
  constexpr double kCollinearTolerance_m = 0.002;
  if (spread.jacobiSvd().singularValues()[1] < kCollinearTolerance_m * kCollinearTolerance_m)
    return unseen_pose();
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
