#pragma once

#include "core/math/random_stream.hpp"
#include "pipeline/place/place_options.hpp"
#include "stages/map/placement.hpp"

namespace morphe::place {

/// A pose of the base in the search: a placement of the config, with its turns as one rotation.
struct BasePlacement {
  Quat world_from_base = Quat::Identity();
  Vec3 shoulder_offset = Vec3::Zero();  ///< robot's shoulder from the human's, in world axes [m]

  /// Returns a direction of the base in the world, its z axis unless another is given.
  Vec3 up(const Vec3& in_base = Vec3::UnitZ()) const { return world_from_base * in_base; }
};

/// Returns the pose that a placement of the config describes.
BasePlacement base_placement_of(const map::PlacementOptions& placement);

/// Returns the placement of the config for a pose, rounded to 0.1 degrees and 1 mm.
map::PlacementOptions placement_of(const BasePlacement& pose);

/// Returns the pose moved into the box of the search and turned as little as possible until its
/// axis is within max_tilt_rad of the mount's direction, and until a standing robot with a body
/// faces the person's way. Fixed coordinates become the configured.
BasePlacement project_to_constraints(const BasePlacement& pose, const BasePlacement& configured,
                                     const PlaceOptions& options);

/// Draws uniformly an offset in the box, an allowed axis and a turn about it, except fixed ones.
BasePlacement random_base_placement(const BasePlacement& configured, const PlaceOptions& options,
                                    math::RandomStream& random);

}  // namespace morphe::place
