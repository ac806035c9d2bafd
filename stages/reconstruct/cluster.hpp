#pragma once

#include <vector>

#include "core/math/rigid.hpp"

namespace morphe::reconstruct {

/// Positions of the markers of a rigid cluster, [marker][frame].
using ClusterTracks = std::vector<std::vector<Vec3>>;

/// Estimates the shape of a rigid cluster. Starts from the frame that shows most markers; then,
/// three times, fits every frame to the shape and updates the shape to the median of the fitted
/// frames. All markers of the shape are unseen if no frame shows three of them.
std::vector<Vec3> median_shape(const ClusterTracks& tracks);

/// Returns the pose of a body of this shape in each frame; NaN with fewer than three seen markers.
std::vector<Pose> fit_poses(const std::vector<Vec3>& shape, const ClusterTracks& tracks);

/// Returns the component-wise median of a track in the frame of a moving body; unseen if no frame
/// shows both.
Vec3 median_in_body(const std::vector<Pose>& world_from_body, const std::vector<Vec3>& track);

/// Fills the gaps in the track of `marker`, in frames with three other markers of its rigid
/// cluster. The marker moves with them; its deviation from their motion is interpolated, to avoid
/// steps.
void fill_marker_gaps(const std::vector<Vec3>& shape, ClusterTracks& tracks, std::size_t marker);

/// Applies fill_marker_gaps() to all tracks, based on recorded positions only.
void fill_cluster_gaps(const std::vector<Vec3>& shape, ClusterTracks& tracks);

}  // namespace morphe::reconstruct
