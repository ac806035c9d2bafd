#pragma once

#include <cstddef>
#include <vector>

#include "core/math/rigid.hpp"

namespace morphe::reconstruct {

/// Estimates the shape of a rigid cluster from its own tracks, [marker][frame]. Every frame is
/// fitted to the shape, and the shape is updated to the median of the fitted frames; this is
/// repeated several times, starting from the frame that shows most markers. All markers are unseen
/// if no frame shows three of them.
std::vector<Vec3> median_shape(const std::vector<std::vector<Vec3>>& tracks);

/// Returns the motion of a body of this shape, one pose per frame; NaN if fewer than three markers
/// are seen.
std::vector<Pose> fit_poses(const std::vector<Vec3>& shape,
                            const std::vector<std::vector<Vec3>>& tracks);

/// Returns the component-wise median of a track's position in a moving body; unseen if it was never
/// seen together with the body.
Vec3 median_in_body(const std::vector<Pose>& world_from_body, const std::vector<Vec3>& track);

/// Fills the gaps of one track of a rigid cluster. If three other markers are seen, it is
/// positioned by their rigid motion plus its own deviation from rigidity before and after the gap
/// (interpolated), so that there is no step at the gap's ends. Other gaps are left.
void fill_marker_gaps(const std::vector<Vec3>& shape, std::vector<std::vector<Vec3>>& tracks,
                      std::size_t marker);

/// Applies fill_marker_gaps() to all tracks, based on recorded positions only.
void fill_cluster_gaps(const std::vector<Vec3>& shape, std::vector<std::vector<Vec3>>& tracks);

}  // namespace morphe::reconstruct
