#pragma once

#include <optional>
#include <vector>

#include "pipeline/setup/find_arm.hpp"

namespace morphe::setup {

/// The flange to which a hand is mounted: z outwards; x near that of the link.
struct Flange {
  int frame = -1;  ///< frame to which the flange is fixed
  Pose frame_from_flange = Pose::Identity();
  Provenance sure = Provenance::derived;
};

/// Finds the flange of an arm. If the last axis turns the hand about itself, z is this axis, and
/// the flange is where the last link ends: at the farthest frame fixed to it on the axis, else at
/// the end of its shapes, else at its origin. If the last axis bends the wrist, z continues the
/// forearm, with the robot at rest, or leads to the end of the last link (assumed).
Flange find_flange(const Kinematics& robot, const Arm& arm, const BodyPoints& points);

/// Returns a point at the end of a moving link: the farthest frame fixed to it, else the end of its
/// shapes, else the point twice as far away as its centre of mass; nullopt if none is 10 mm away.
std::optional<Vec3> end_of_link(const Kinematics& robot, int frame, const BodyPoints& points);

}  // namespace morphe::setup
