#pragma once

#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::math {

/// Returns the rotation R that maximises trace(Rᵀ M) (Kabsch: singular vectors, det R = +1).
Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& m);

/// Returns the rigid transformation T = (R, t) that minimises sum_k |T from_k - to_k|^2 over the
/// pairs of known points; R is the rotation nearest to the cross-covariance. All NaN for fewer than
/// three pairs, or collinear ones (second singular value of the centred points below 2 mm).
Pose fit_rigid_transform(const std::vector<Vec3>& from, const std::vector<Vec3>& to);

/// Returns the root mean square of |to_from from_k - to_k| over pairs of known points, or NaN.
double rigid_residual(const Pose& to_from, const std::vector<Vec3>& from,
                      const std::vector<Vec3>& to);

/// Returns a pose whose elements are all NaN.
inline Pose unseen_pose() {
  Pose pose;
  pose.matrix().setConstant(kUnknown);
  return pose;
}

}  // namespace morphe::math
