#pragma once

#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// Rigid bodies of an optical system, and bones of the skeletons that it fits.
struct RigidBodies {
  BodyStream poses;  ///< poses of the bodies' pivots and of the bones' proximal ends
  /// [S] extent of a body's markers in its frame; may be empty.
  std::vector<Eigen::AlignedBox3d> extent;
  std::vector<bool> bone;  ///< [S] true for a bone
};

/// Adds bodies, in the world and with their names mapped, to a demonstration. Bones, and bodies
/// that are named as a joint (right_wrist, …), become joints of the skeleton in addition to
/// existing ones, on the same times; `wrist`, `elbow` and `shoulder` become sensors; all others
/// become objects: boxes around their markers, spheres if no marker is known. This is added to
/// `reports`.
void add_rigid_bodies(const RigidBodies& bodies, Demonstration& demonstration);

}  // namespace morphe::imports
