#pragma once

#include "core/motion/geometry.hpp"

namespace morphe::math {

/// Returns the rotation R of the least angle with R a = b |a| / |b|, from vectors of any length
/// above 0. Where b = -a, its axis is some axis at right angles to a.
Quat shortest_rotation(const Vec3& a, const Vec3& b);

/// Eigenvalues of a symmetric matrix, ascending, and its unit eigenvectors as columns.
struct PrincipalAxes {
  Vec3 moments;
  Eigen::Matrix3d axes;
};

/// Returns S = sum_k moments_k axes_k axes_kᵀ; only the lower triangle of S is read.
PrincipalAxes principal_axes(const Eigen::Matrix3d& symmetric);

}  // namespace morphe::math
