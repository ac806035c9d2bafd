#pragma once

#include <optional>
#include <vector>

#include "pipeline/motion/geometry.hpp"

namespace morphe {

struct ArmLengths {
  double upper_arm = 0, forearm = 0;  ///< shoulder to elbow, elbow to wrist [m]
};

/// Segment lengths of an average adult: 0.186 and 0.146 of the stature (Drillis and Contini 1966).
ArmLengths arm_lengths_of_stature(double stature_m);

/// The elbow of an arm that hangs naturally: on the circle |elbow - shoulder| = upper_arm,
/// |elbow - wrist| = forearm the point furthest along (sin a, 0, -cos a), where `outward` = a turns
/// from straight down to the right (world: X right, Y forward, Z up; a right arm). If that
/// direction lies along the shoulder-wrist line, furthest back. A wrist out of reach is taken at
/// the nearest distance that can be reached. NaN if shoulder or wrist is, or if they coincide.
Vec3 natural_elbow(const Vec3& shoulder, const Vec3& wrist, const ArmLengths& lengths,
                   double outward);

/// A point near `wanted` whose distance from every seen wrist is at most `reach` (to 1 µm): while a
/// wrist is further, onto the ball around the furthest. Nothing if 10,000 such steps do not get
/// there: no such point, or hardly one.
std::optional<Vec3> shoulder_within_reach(const Vec3& wanted, const std::vector<Vec3>& wrists,
                                          double reach);

}  // namespace morphe
