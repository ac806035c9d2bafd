#include "stages/import/audit/marker_clusters.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/rigid.hpp"
#include "core/math/statistics.hpp"
#include "stages/import/audit/sampled_points.hpp"

namespace morphe::imports {
bool is_cluster_marker(const std::string& name, const std::string& cluster) {
  return name.size() > cluster.size() && name.starts_with(cluster) &&
         name.find_first_not_of("0123456789", cluster.size()) == std::string::npos;
}

Vec3 static_position(const Demonstration& recording, const std::string& marker) {
  const auto& trial = recording.calibration.markers;
  if (!trial) return unknown_point();
  const auto column = std::ranges::find(trial->names, marker) - trial->names.begin();
  std::vector<Vec3> track;
  for (std::size_t i = 0; column < std::ssize(trial->names) && i < trial->position.rows; ++i)
    track.push_back(trial->position(i, column));
  return math::median_point(track);
}

ClusterPoses cluster_poses(const Demonstration& recording, const std::string& cluster) {
  ClusterPoses poses;
  const auto& markers = recording.streams.markers;
  std::vector<std::size_t> columns;
  std::vector<Vec3> shape;
  for (std::size_t k = 0; markers && k < markers->names.size(); ++k) {
    if (!is_cluster_marker(markers->names[k], cluster)) continue;
    const Vec3 position = static_position(recording, markers->names[k]);
    if (!is_known(position)) continue;
    columns.push_back(k);
    shape.push_back(position);
  }
  if (shape.size() < 3) return poses;
  const std::size_t step = sample_step(markers->time.size());
  std::vector<double> misfits;
  for (std::size_t i = 0; i < markers->time.size(); i += step) {
    std::vector<Vec3> seen;
    for (const std::size_t k : columns) seen.push_back(markers->position(i, k));
    poses.frames.push_back(i);
    poses.world_from_static.push_back(math::fit_rigid_transform(shape, seen));
    const double misfit = math::rigid_residual(poses.world_from_static.back(), shape, seen);
    if (std::isfinite(misfit)) misfits.push_back(misfit);
  }
  poses.misfit_m = math::median(misfits);
  return poses;
}

}  // namespace morphe::imports
