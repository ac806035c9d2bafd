#include "core/math/rotation.hpp"

#include <Eigen/Eigenvalues>

namespace morphe::math {

// FromTwoVectors() instantiates a singular value decomposition, principal_axes() an eigenvalue
// solver. Compiling them takes seconds for each file, so that only this file contains them.

Quat shortest_rotation(const Vec3& a, const Vec3& b) { return Quat::FromTwoVectors(a, b); }

PrincipalAxes principal_axes(const Eigen::Matrix3d& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace morphe::math
