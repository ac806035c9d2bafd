#pragma once

#include <cstddef>
#include <vector>

#include "core/math/rigid.hpp"

namespace morphe::reconstruct {

/// Shape of a rigid cluster from its own tracks, [marker][frame]: every frame is fitted to the
/// shape and the shape becomes the median of what is brought back, a few times over, beginning
/// with the frame that shows most markers. All unseen if no frame shows three of them.
std::vector<Vec3> median_shape(const std::vector<std::vector<Vec3>>& tracks);

/// Motion of a body of this shape, a pose a frame: NaN where fewer than three markers are seen.
std::vector<Pose> poses_of(const std::vector<Vec3>& shape,
                           const std::vector<std::vector<Vec3>>& tracks);

/// Median, component by component, of where a track lies in a moving body; unseen if it never was
/// together with the body.
Vec3 median_in_body(const std::vector<Pose>& world_from_body, const std::vector<Vec3>& track);

/// Fills the gaps of one track of a rigid cluster: where three others are seen, it is put where
/// their rigid motion carries it, plus its own deviation from rigidity before and after the gap
/// (interpolated): no step at the gap's ends. Other gaps are left.
void complete_marker(const std::vector<Vec3>& shape, std::vector<std::vector<Vec3>>& tracks,
                     std::size_t marker);

/// complete_marker() of all; only what was recorded carries a marker.
void complete_cluster(const std::vector<Vec3>& shape, std::vector<std::vector<Vec3>>& tracks);

}  // namespace morphe::reconstruct
