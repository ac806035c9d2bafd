#pragma once

#include <optional>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::human {

/// The segment lengths of a human arm.
struct ArmLengths {
  double upper_arm = 0, forearm = 0;  ///< shoulder to elbow, elbow to wrist [m]
};

/// Returns the segment lengths of an average adult: 0.186 and 0.146 of the stature (Drillis and
/// Contini 1966).
ArmLengths arm_lengths_of_stature(double stature_m);

/// Estimates the elbow of a naturally hanging arm (world: X right, Y forward, Z up; a right arm).
/// The elbow is on the circle |elbow - shoulder| = upper_arm, |elbow - wrist| = forearm, rotated
/// about the shoulder-wrist line by the swivel angle `outward` to the right of the circle's point
/// furthest along (0, -2, -1). This is the lowest point while the wrist is in front, and the
/// rearmost point while the wrist is below the shoulder, so that the elbow does not flip when the
/// hand is drawn back past the body. A wrist out of reach is replaced by the nearest reachable
/// distance. Returns NaN if shoulder or wrist is NaN, if they coincide, or if the wrist is in that
/// very direction from the shoulder.
Vec3 elbow_from_swivel(const Vec3& shoulder, const Vec3& wrist, const ArmLengths& lengths,
                       double outward);

/// Returns a point near `wanted` whose distance from every known wrist is at most `reach` (to 1
/// µm), by repeated projection onto the sphere around the furthest wrist. Returns nullopt if 10,000
/// projections do not suffice, because the set of such points is empty or nearly empty.
std::optional<Vec3> shoulder_within_reach(const Vec3& wanted, const std::vector<Vec3>& wrists,
                                          double reach);

}  // namespace morphe::human
