#include "core/math/rotation.hpp"

#include <Eigen/Eigenvalues>

namespace morphe::math {

// Eigen compiles a singular value decomposition for the first and an eigenvalue solver for the
// second, which takes seconds for each file that calls them, so they are called only here.

Quat shortest_rotation(const Vec3& a, const Vec3& b) { return Quat::FromTwoVectors(a, b); }

PrincipalAxes principal_axes(const Eigen::Matrix3d& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace morphe::math
