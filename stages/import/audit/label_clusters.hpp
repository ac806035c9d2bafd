#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "stages/import/audit/exchanges.hpp"

namespace morphe::imports {

/// Markers on one part of the body, which keep their distances.
struct RigidCluster {
  std::string part;                  ///< "right hand"
  std::vector<std::size_t> columns;  ///< of its markers in the recording
  std::vector<Vec3> shape;           ///< their places in the static trial's world; or empty
};

/// Returns the clusters of three or more markers that a recording shows, with their shapes in the
/// static trial, if that shows three of them.
std::vector<RigidCluster> rigid_clusters(const MarkerStream& markers,
                                         const std::optional<MarkerStream>& static_trial);

/// Returns the median position of the markers with this part of the body in their names; unknown
/// if there are none.
Vec3 median_of_part(const MarkerStream& markers, const std::string& part);

/// Returns up to `max_count` frames, evenly distributed over those from `begin` to `end`.
Array2D<Vec3> sample_frames(const Array2D<Vec3>& position, std::size_t begin, std::size_t end,
                            std::size_t max_count);

/// Returns the points of the cluster in a frame if its tracks are in the columns of `source`.
std::vector<Vec3> cluster_points(const Array2D<Vec3>& position, std::size_t frame,
                                 const RigidCluster& cluster, const Permutation& source);

/// How badly tracks fit a cluster.
struct ClusterMisfit {
  double error_m = kUnknown;  ///< NaN if too few of its markers are seen together
  double size_m = 0;          ///< RMS distance of two markers; 0 if the shape is known
  std::size_t frames = 0;     ///< that show all of its markers

  double cost_m() const;  ///< error and weighted size
};

/// Returns how badly the tracks in the columns of `source` fit the cluster, in the frames that show
/// all of it. With a shape the error is the median over the frames of the RMS of the rigid fit;
/// otherwise, by d_ab the distance of two markers and by m_ab its median over the frames, the 90 %
/// quantile of sqrt(mean_ab (d_ab - m_ab)^2), and the size is sqrt(mean_ab m_ab^2).
ClusterMisfit cluster_misfit(const Array2D<Vec3>& position, const RigidCluster& cluster,
                             const Permutation& source);

/// Returns the largest mean distance of a marker of the cluster from the others, over the mean
/// distance of those others; 0 with fewer than four markers.
double outlier_ratio(const Array2D<Vec3>& position, const RigidCluster& cluster,
                     const Permutation& source);

/// Returns the cluster with the shape of the frame whose distances are nearest to their medians.
RigidCluster with_recorded_shape(const Array2D<Vec3>& position, RigidCluster cluster);

}  // namespace morphe::imports
