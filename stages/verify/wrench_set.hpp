#pragma once

#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::verify {

/// A wrench or a twist: linear part, then angular part.
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// The wrenches (f, tau / rho) that pads can exert on an object together (docs/grasp_quality.md).
/// Each contact contributes all G (1, y) with |y| <= 1, times its normal force; the columns of G
/// are the wrenches of the unit normal, of mu times two tangents and of the moment gamma about the
/// normal.
struct WrenchSet {
  std::vector<Eigen::Matrix<double, 6, 4>> contacts;  ///< G of each contact
  /// true: each normal force is in [0, 1]; false: they sum to 1
  bool individually_bounded = false;
};

/// Returns G for the lever of a contact point from the centre and the torsion gamma, both divided
/// by the torque scale.
Eigen::Matrix<double, 6, 4> contact_wrench_basis(const Vec3& lever, const Vec3& normal,
                                                 double friction, double torsion);

/// The wrench with the greatest power in a twist u, and that power h(u).
struct Support {
  double value = 0;
  Vector6 wrench = Vector6::Zero();
};
/// Returns the support of the wrench set in the direction u.
Support support(const WrenchSet& pressing, const Vector6& u);

}  // namespace morphe::verify
