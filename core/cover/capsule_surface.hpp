#pragma once

#include <vector>

#include "core/collision/distance.hpp"
#include "core/cover/voxels.hpp"

namespace morphe::cover {

/// Returns the distance of a point from the segment between two points.
double distance_to_segment(const Vec3& point, const Vec3& from, const Vec3& to);

/// Returns the signed distance of a point from the union of capsules, < 0 inside.
double union_signed_distance(const std::vector<collision::CapsuleBody>& capsules,
                             const Vec3& point);

/// Returns points on a capsule's surface, `ring_points` on each of `rings` of equal area.
std::vector<Vec3> sample_capsule_surface(const collision::CapsuleBody& capsule, int rings,
                                         int ring_points);

/// Returns the squared distance from the body, 0 inside, integrated over a capsule's surface [m⁴].
double standoff_cost(const collision::CapsuleBody& capsule, const Voxels& voxels);

/// Returns the mean square distance of the capsules' outer surface from the body [m²].
double mean_square_standoff(const std::vector<collision::CapsuleBody>& capsules,
                            const Voxels& voxels);

}  // namespace morphe::cover
