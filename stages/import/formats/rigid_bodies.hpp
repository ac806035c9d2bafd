#pragma once

#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// Rigid bodies of an optical system, and bones of the skeletons that it fits.
struct RigidBodies {
  BodyStream poses;                         ///< of bodies' pivots and of bones' beginnings
  std::vector<Eigen::AlignedBox3d> extent;  ///< [S] of a body's markers in its frame; empty = none
  std::vector<bool> bone;                   ///< [S]
};

/// Puts bodies, in the world and with their names mapped, into a demonstration. Bones, and bodies
/// that are called as a joint (right_wrist, …), become joints of the skeleton beside those that are
/// there, on the same times; `wrist`, `elbow` and `shoulder` become sensors; the rest objects:
/// boxes around their markers, balls where none is known. Said in `reports`.
void add_rigid_bodies(const RigidBodies& bodies, Demonstration& demonstration);

}  // namespace morphe::imports
