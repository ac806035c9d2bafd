#pragma once

#include "core/motion/geometry.hpp"

namespace morphe::robot {

/// The Denavit-Hartenberg convention: the order of the joint's rotation and the link's constant
/// transformations.
///   modified (Craig)  T = Rx(alpha) Tx(a) Rz(theta) Tz(d)   alpha, a of the link before the joint
///   standard          T = Rz(theta) Tz(d) Tx(a) Rx(alpha)   all of the link after the joint
enum class DhConvention { modified, standard };

/// One row of a Denavit-Hartenberg table.
struct DhRow {
  double theta = 0;     ///< added to the joint's angle [rad]
  double d = 0, a = 0;  ///< along z, along x [m]
  double alpha = 0;     ///< [rad]
};

/// A row without theta, split at the joint's rotation: T = before * Rz(angle) * after. In the
/// standard convention `after` belongs to the next joint's frame, or to the tip.
struct DhLink {
  Pose before = Pose::Identity(), after = Pose::Identity();
};
/// Returns the two constant factors of a row in the given convention.
DhLink dh_link(DhConvention convention, const DhRow& row);

}  // namespace morphe::robot
