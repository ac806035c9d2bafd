#pragma once

#include <vector>

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// Rigid bodies of an optical system, and bones of the skeletons that it fits.
struct RigidBodies {
  BodyStream poses;  ///< [N, S] of the bodies' pivots and of the bones' proximal ends
  std::vector<Eigen::AlignedBox3d> extent;  ///< [S] around markers, in the body's frame; or empty
  std::vector<bool> bone;                   ///< [S] true for a bone
};

/// Adds bodies, in the world and with their names mapped, to a demonstration, and reports them in
/// `import_notes`. Bones, and bodies that are named as a joint (right_wrist, …), are added to the
/// joints of the skeleton, which must have the same times. Bodies named `wrist`, `elbow` and
/// `shoulder` are added to the sensors. All others that were ever tracked become objects: boxes
/// around their markers, or spheres if no marker is known.
void add_rigid_bodies(const RigidBodies& bodies, Demonstration& demonstration);

}  // namespace morphe::imports
