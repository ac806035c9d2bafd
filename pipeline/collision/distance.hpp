#pragma once

#include "pipeline/motion/geometry.hpp"
#include "pipeline/motion/scene.hpp"

namespace morphe {

/// Points within `radius` of the segment from–to, in one common frame [m].
struct CapsuleBody {
  Vec3 from, to;
  double radius = 0;
};

/// Signed distance of two bodies, > 0 apart, < 0 how deep the first's deepest point lies inside the
/// second. Moving the first by a small u changes the distance by normal · u.
struct Separation {
  double distance = 0;
  Vec3 on_first, on_second;  ///< nearest points (of a capsule: on its surface)
  Vec3 normal;               ///< unit, from the second to the first
};

/// Exact, closed form.
Separation capsule_capsule(const CapsuleBody& first, const CapsuleBody& second);

/// Capsule against a sphere, box, cylinder or capsule at a pose: the solid's signed distance is a
/// convex function along the capsule's segment; its minimum is found to 1e-9 m.
Separation capsule_solid(const CapsuleBody& first, const SceneObject& solid, const Pose& pose);

}  // namespace morphe
