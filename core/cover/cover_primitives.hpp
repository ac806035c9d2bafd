#pragma once

#include <vector>

#include "core/collision/distance.hpp"
#include "core/motion/scene.hpp"

namespace morphe::cover {

/// Returns capsules, at most `budget`, that enclose boxes, cylinders and spheres, without sampling
/// (h, w, d are half sizes, e ≥ 0 is how far the segments end before the ends of the body):
///   sphere    itself
///   box       k × l capsules along its longest side h, which divide the others into cells of w, d:
///             r² = w² + d² + e². They stand off the sides by r - w and r - d, the ends by r - e
///   cylinder  one capsule along it, r² = R² + e², or, if it is flat, those of k × l cells of the
///             slab that contains it, each as long as the chord that it must cover
/// k, l and e minimise the square of these standoffs, weighted with the areas of the faces. Several
/// bodies share the budget such that their sum is least. The list is empty if there are more bodies
/// than capsules, and if one of them is of another shape.
std::vector<collision::CapsuleBody> cover_primitives(const std::vector<SceneObject>& bodies,
                                                     int budget);

/// Returns the distance of a point from the nearest of these bodies, 0 inside.
double distance_from_primitives(const std::vector<SceneObject>& bodies, const Vec3& point);

}  // namespace morphe::cover
