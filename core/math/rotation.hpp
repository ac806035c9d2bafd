#pragma once

#include "core/motion/geometry.hpp"

namespace morphe::math {

/// Returns the rotation R with the smallest angle for which R a = b |a| / |b|, for vectors of any
/// positive length. If b = -a, the axis is an arbitrary one perpendicular to a.
Quat shortest_rotation(const Vec3& a, const Vec3& b);

/// The eigenvalues of a symmetric matrix, ascending, and its unit eigenvectors as columns.
struct PrincipalAxes {
  Vec3 moments;
  Eigen::Matrix3d axes;
};

/// Returns the decomposition S = sum_k moments_k axes_k axes_kᵀ; reads only S's lower triangle.
PrincipalAxes principal_axes(const Eigen::Matrix3d& symmetric);

}  // namespace morphe::math
