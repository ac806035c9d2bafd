#pragma once

#include "core/math/random_stream.hpp"
#include "pipeline/place/place_options.hpp"
#include "stages/map/placement.hpp"

namespace morphe::place {

/// Where a base stands, as it is searched for: the config's placement without its turns.
struct Stand {
  Quat world_from_base = Quat::Identity();
  Vec3 shoulder_offset = Vec3::Zero();  ///< from the human shoulder to the robot's, world axes [m]

  Vec3 up() const { return world_from_base * Vec3::UnitZ(); }  ///< the base's z axis
};

/// The box in which the robot's shoulder is looked for, from the human's [m].
inline const Vec3 kLeastOffset(-0.6, -0.8, -0.6), kMostOffset(0.6, 0.4, 0.6);

Stand stand_of(const map::PlacementOptions& placement);

/// Turns about z, y and x to a tenth of a degree, the offset to a millimetre: what is written is
/// what was measured. Turns by nothing are left out.
map::PlacementOptions placement_of(const Stand& stand);

/// The nearest that the mount and what is kept allow: the base's axis goes the shortest way to the
/// mount's directions, the shoulder into the box.
Stand allowed(const Stand& stand, const Stand& configured, const PlaceOptions& options);

/// Evenly over what is allowed: offsets over the box, the base's axis over the mount's part of the
/// sphere, turns about it over the circle.
Stand random_stand(const Stand& configured, const PlaceOptions& options,
                   math::RandomStream& random);

}  // namespace morphe::place
