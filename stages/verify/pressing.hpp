#pragma once

#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::verify {

using Vector6 = Eigen::Matrix<double, 6, 1>;

/// What pads can do to an object together (docs/grasp_quality.md): wrenches (f, tau / rho). Of each
/// contact all G (1, y) with |y| <= 1, times its normal force; the columns of G are the wrenches of
/// the unit normal, of mu times two tangents and of the moment gamma about the normal.
struct Pressing {
  std::vector<Eigen::Matrix<double, 6, 4>> contacts;  ///< G of each
  bool each = false;  ///< normal forces from 0 to 1 each; else they sum to 1
};

/// G. Point from the centre and gamma over the torque scale.
Eigen::Matrix<double, 6, 4> pressing_of(const Vec3& lever, const Vec3& normal, double friction,
                                        double torsion);

/// The wrench that does most in a twist u, and how much that is: h(u).
struct Farthest {
  double most = 0;
  Vector6 wrench = Vector6::Zero();
};
Farthest farthest(const Pressing& pressing, const Vector6& u);

}  // namespace morphe::verify
