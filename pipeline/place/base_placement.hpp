#pragma once

#include "core/math/random_stream.hpp"
#include "pipeline/place/place_options.hpp"
#include "stages/map/placement.hpp"

namespace morphe::place {

/// A placement of the base as represented in the search: the config's placement with one rotation
/// instead of a series of turns.
struct BasePlacement {
  /// The orientation of the base in the world.
  Quat world_from_base = Quat::Identity();
  /// Offset from the human shoulder to the robot's, in world axes [m].
  Vec3 shoulder_offset = Vec3::Zero();

  Vec3 up() const { return world_from_base * Vec3::UnitZ(); }  ///< returns the z axis of the base
};

/// The limits of the shoulder offset in the search [m].
inline const Vec3 kMinShoulderOffset_m(-0.6, -0.8, -0.6), kMaxShoulderOffset_m(0.6, 0.4, 0.6);

/// Converts a placement of the config.
BasePlacement base_placement_of(const map::PlacementOptions& placement);

/// Converts to a placement of the config, with turns about z, y and x rounded to a tenth of a
/// degree and the offset to a millimetre, so that the placement that is written is the one that was
/// evaluated. Turns of 0 are left out.
map::PlacementOptions placement_of(const BasePlacement& stand);

/// Returns the nearest placement that satisfies the mount and the fixed coordinates: the axis of
/// the base is rotated by the smallest angle to the directions of the mount, and the shoulder is
/// moved into the box.
BasePlacement project_to_constraints(const BasePlacement& stand, const BasePlacement& configured,
                                     const PlaceOptions& options);

/// Draws a placement uniformly from the allowed ones: the offset from the box, the axis of the base
/// from the mount's part of the sphere, and the turn about it from the circle.
BasePlacement random_base_placement(const BasePlacement& configured, const PlaceOptions& options,
                                    math::RandomStream& random);

}  // namespace morphe::place
