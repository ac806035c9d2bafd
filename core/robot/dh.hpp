#pragma once

#include "core/motion/geometry.hpp"

namespace morphe::robot {

/// Where a row's angle turns, seen from the link's fixed lengths:
///   modified (Craig)  T = Rx(alpha) Tx(a) Rz(theta) Tz(d)   alpha, a of the link before the joint
///   standard          T = Rz(theta) Tz(d) Tx(a) Rx(alpha)   all of the link after the joint
enum class DhConvention { modified, standard };

struct DhRow {
  double theta = 0;  ///< added to the joint's angle [rad]
  double d = 0, a = 0;
  double alpha = 0;  ///< [rad]
};

/// A row without its angle, split at the rotation: T = before * Rz(angle) * after. A standard row
/// leaves its link behind the joint, for the next joint's frame or the tip to include.
struct DhLink {
  Pose before = Pose::Identity(), after = Pose::Identity();
};
DhLink dh_link(DhConvention convention, const DhRow& row);

}  // namespace morphe::robot
