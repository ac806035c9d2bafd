#pragma once

#include <optional>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::human {

/// The segment lengths of a human arm.
struct ArmLengths {
  double upper_arm = 0, forearm = 0;  ///< shoulder to elbow, elbow to wrist [m]
};

/// Returns an average adult's lengths: upper arm 0.186, forearm 0.146 of stature (Drillis and
/// Contini 1966).
ArmLengths arm_lengths_of_stature(double stature_m);

/// Estimates the elbow of a right arm that hangs naturally (world: X right, Y forward, Z up). The
/// elbow is on the circle |elbow - shoulder| = upper_arm, |elbow - wrist| = forearm. Its reference
/// is the circle's point furthest along (0, -2, -1): the lowest one while the wrist is in front,
/// the rearmost one while the wrist is below the shoulder, so that the elbow does not flip when the
/// hand is drawn back past the body. The elbow is rotated from there to the right about the
/// shoulder-wrist line by the swivel angle `outward` [rad]. If the wrist is too far from the
/// shoulder, or too near, the nearest possible distance is assumed. Returns NaN if shoulder or
/// wrist is NaN, if they coincide, or if they are in line with (0, -2, -1).
Vec3 elbow_from_swivel(const Vec3& shoulder, const Vec3& wrist, const ArmLengths& lengths,
                       double outward);

/// Returns a shoulder near `estimate` whose distance from every known wrist is at most arm_length_m
/// (to 1 µm), by repeated projection onto the sphere of this radius around the furthest wrist.
/// Returns nullopt if 10,000 projections do not suffice, because there is hardly any such shoulder.
std::optional<Vec3> shoulder_within_reach(const Vec3& estimate, const std::vector<Vec3>& wrists,
                                          double arm_length_m);

}  // namespace morphe::human
