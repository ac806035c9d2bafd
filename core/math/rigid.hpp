#pragma once

#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::math {

/// The rotation R that maximises trace(Rᵀ M) (Kabsch: singular vectors, det R = +1).
Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& m);

/// Rigid motion T = (R, t) that minimises sum_k |T from_k - to_k|^2 over the pairs with both points
/// seen (R nearest to the cross-covariance). All NaN with fewer than
/// three pairs or when they are collinear (second singular value of the centred points below 2 mm).
Pose fit_rigid(const std::vector<Vec3>& from, const std::vector<Vec3>& to);

/// Root mean square of |T from_k - to_k| over the pairs with both points seen [m]; NaN if none.
double rigid_residual(const Pose& to_from, const std::vector<Vec3>& from,
                      const std::vector<Vec3>& to);

inline Pose unseen_pose() {
  Pose pose;
  pose.matrix().setConstant(kNotSeen);
  return pose;
}

}  // namespace morphe::math
