#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// Poses of a cluster of markers, relative to the static trial.
struct ClusterPoses {
  std::vector<std::size_t> frames;      ///< of the recording, with the step of sampled_points()
  std::vector<Pose> world_from_static;  ///< [frames] NaN with fewer than three seen markers
  double misfit_m = kUnknown;           ///< median over the frames of the RMS of the rigid fit
};

/// Fits the markers of a cluster in the static trial, "RHAN1", "RHAN2", … for "RHAN", to those in
/// the recording. There are no frames with fewer than three markers, or without a static trial.
ClusterPoses cluster_poses(const Demonstration& recording, const std::string& cluster);

/// Returns true if a marker belongs to a cluster: "RHAN1" to "RHAN".
bool is_cluster_marker(const std::string& name, const std::string& cluster);

/// Returns the median position of a marker in the static trial; unseen if it does not show it.
Vec3 static_position(const Demonstration& recording, const std::string& marker);

}  // namespace morphe::imports
