#pragma once

#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::verify {

/// A wrench or a twist: linear part, then angular part.
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// The wrenches (f, tau / rho) that pads can exert on an object together, with the characteristic
/// length rho (docs/grasp_quality.md). A contact with the normal force p adds p G (1, y), |y| <= 1.
struct WrenchSet {
  std::vector<Eigen::Matrix<double, 6, 4>> contact_bases;  ///< G of each contact
  bool limits_each_force = false;  ///< true: each normal force is in [0, 1]; false: they sum to 1
};

/// Returns G. Its columns are the wrenches of a unit force along the unit `normal` (into the
/// object), of forces mu along two tangents, and of the moment gamma about the normal. The arm from
/// the centre of mass to the contact and gamma must already be divided by rho.
Eigen::Matrix<double, 6, 4> contact_wrench_basis(const Vec3& moment_arm, const Vec3& normal,
                                                 double mu, double gamma);

/// The support function h(u): the greatest power w.u of any wrench w of a set in a twist u.
struct Support {
  double value = 0;                  ///< h(u)
  Vector6 wrench = Vector6::Zero();  ///< a wrench with this power
};
/// Returns the support of a set in the direction u; 0 and the zero wrench without contacts.
Support support(const WrenchSet& wrenches, const Vector6& u);

}  // namespace morphe::verify
