#pragma once

#include <optional>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::human {

struct ArmLengths {
  double upper_arm = 0, forearm = 0;  ///< shoulder to elbow, elbow to wrist [m]
};

/// Segment lengths of an average adult: 0.186 and 0.146 of the stature (Drillis and Contini 1966).
ArmLengths arm_lengths_of_stature(double stature_m);

/// The elbow of an arm that hangs naturally (world: X right, Y forward, Z up; a right arm). It lies
/// on the circle |elbow - shoulder| = upper_arm, |elbow - wrist| = forearm, turned about the
/// shoulder-wrist line by `outward` to the right of the circle's point furthest along (0, -2, -1):
/// the lowest one while the wrist is ahead, the one furthest back while it is below the shoulder,
/// so that the elbow does not flip when the hand is drawn back past the body. A wrist out of reach
/// is taken at the nearest distance that can be reached. NaN if shoulder or wrist is, if they
/// coincide, or if the wrist lies along that very direction.
Vec3 natural_elbow(const Vec3& shoulder, const Vec3& wrist, const ArmLengths& lengths,
                   double outward);

/// A point near `wanted` whose distance from every seen wrist is at most `reach` (to 1 µm): while a
/// wrist is further, onto the ball around the furthest. Nothing if 10,000 such steps do not get
/// there: no such point, or hardly one.
std::optional<Vec3> shoulder_within_reach(const Vec3& wanted, const std::vector<Vec3>& wrists,
                                          double reach);

}  // namespace morphe::human
