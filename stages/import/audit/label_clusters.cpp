#include "stages/import/audit/label_clusters.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/math/rigid.hpp"
#include "core/math/statistics.hpp"
#include "stages/import/audit/constants.hpp"
#include "stages/import/recording/arm_names.hpp"

namespace morphe::imports {
namespace {

std::vector<Vec3> column_of(const Array2D<Vec3>& position, std::size_t column) {
  std::vector<Vec3> track(position.rows);
  for (std::size_t i = 0; i < position.rows; ++i) track[i] = position(i, column);
  return track;
}

bool ever_seen(const Array2D<Vec3>& position, std::size_t column) {
  return std::ranges::any_of(column_of(position, column), [](auto& p) { return is_known(p); });
}

std::size_t known_count(const std::vector<Vec3>& points) {
  return static_cast<std::size_t>(
      std::ranges::count_if(points, [](const Vec3& p) { return is_known(p); }));
}

std::vector<Vec3> static_shape(const MarkerStream& static_trial, const MarkerStream& markers,
                               const RigidCluster& cluster) {
  std::vector<Vec3> shape;
  for (const std::size_t column : cluster.columns) {
    const auto name = std::ranges::find(static_trial.names, markers.names[column]);
    shape.push_back(name == static_trial.names.end()
                        ? unknown_point()
                        : math::median_point(
                              column_of(static_trial.position, name - static_trial.names.begin())));
  }
  return known_count(shape) < kMinClusterSize ? std::vector<Vec3>{} : shape;
}

double shape_misfit(const std::vector<Vec3>& shape, const std::vector<Vec3>& points) {
  return math::rigid_residual(math::fit_rigid_transform(shape, points), shape, points);
}

/// Returns the distances between the markers of a cluster, [frame][pair].
std::vector<std::vector<double>> pair_distances(const std::vector<std::vector<Vec3>>& frames) {
  std::vector<std::vector<double>> distances(frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const std::vector<Vec3>& points = frames[i];
    for (std::size_t a = 0; a < points.size(); ++a) {
      for (std::size_t b = a + 1; b < points.size(); ++b)
        distances[i].push_back((points[a] - points[b]).norm());
    }
  }
  return distances;
}

std::vector<double> medians_over_frames(const std::vector<std::vector<double>>& distances) {
  std::vector<double> medians;
  for (std::size_t pair = 0; !distances.empty() && pair < distances[0].size(); ++pair) {
    std::vector<double> over_frames;
    for (const std::vector<double>& frame : distances) over_frames.push_back(frame[pair]);
    medians.push_back(math::median(std::move(over_frames)));
  }
  return medians;
}

double root_mean_square(const std::vector<double>& values) {
  std::vector<double> squares;
  for (const double value : values) squares.push_back(value * value);
  return std::sqrt(math::mean(squares));
}

/// Returns the RMS deviation of the distances from their medians, [frame].
std::vector<double> distance_deviations(const std::vector<std::vector<double>>& distances,
                                        const std::vector<double>& medians) {
  std::vector<double> deviations;
  for (std::vector<double> frame : distances) {
    for (std::size_t pair = 0; pair < frame.size(); ++pair) frame[pair] -= medians[pair];
    deviations.push_back(root_mean_square(frame));
  }
  return deviations;
}

/// Returns the frames that show all markers of the cluster, [frame][marker].
std::vector<std::vector<Vec3>> complete_frames(const Array2D<Vec3>& position,
                                               const RigidCluster& cluster,
                                               const Permutation& source) {
  std::vector<std::vector<Vec3>> frames;
  for (std::size_t i = 0; i < position.rows; ++i) {
    std::vector<Vec3> points = cluster_points(position, i, cluster, source);
    if (known_count(points) == points.size()) frames.push_back(std::move(points));
  }
  return frames;
}

}  // namespace

std::vector<RigidCluster> rigid_clusters(const MarkerStream& markers,
                                         const std::optional<MarkerStream>& static_trial) {
  std::map<std::string, RigidCluster> by_part;
  for (std::size_t k = 0; k < markers.names.size(); ++k) {
    const std::string part = body_part(markers.names[k]);
    if (!part.empty() && ever_seen(markers.position, k)) by_part[part].columns.push_back(k);
  }
  std::vector<RigidCluster> clusters;
  for (auto& [part, cluster] : by_part) {
    if (cluster.columns.size() < kMinClusterSize) continue;
    cluster.part = part;
    if (static_trial) cluster.shape = static_shape(*static_trial, markers, cluster);
    clusters.push_back(std::move(cluster));
  }
  return clusters;
}

Vec3 median_of_part(const MarkerStream& markers, const std::string& part) {
  std::vector<Vec3> points;
  for (std::size_t k = 0; k < markers.names.size(); ++k) {
    if (body_part(markers.names[k]) == part)
      points.push_back(math::median_point(column_of(markers.position, k)));
  }
  return math::median_point(points);
}

Array2D<Vec3> sample_frames(const Array2D<Vec3>& position, std::size_t begin, std::size_t end,
                            std::size_t max_count) {
  const std::size_t count = std::min(max_count, end - begin);
  Array2D<Vec3> sampled(count, position.cols, unknown_point());
  for (std::size_t s = 0; s < count; ++s) {
    const std::size_t i = begin + (2 * s + 1) * (end - begin) / (2 * count);
    for (std::size_t k = 0; k < position.cols; ++k) sampled(s, k) = position(i, k);
  }
  return sampled;
}

std::vector<Vec3> cluster_points(const Array2D<Vec3>& position, std::size_t frame,
                                 const RigidCluster& cluster, const Permutation& source) {
  std::vector<Vec3> points;
  for (const std::size_t column : cluster.columns)
    points.push_back(position(frame, source[column]));
  return points;
}

double ClusterMisfit::cost_m() const { return error_m + kSizeWeight * size_m; }

ClusterMisfit cluster_misfit(const Array2D<Vec3>& position, const RigidCluster& cluster,
                             const Permutation& source) {
  const auto frames = complete_frames(position, cluster, source);
  if (!cluster.shape.empty()) {
    std::vector<double> errors;
    for (const std::vector<Vec3>& points : frames)
      errors.push_back(shape_misfit(cluster.shape, points));
    return {math::quantile(std::move(errors), kShapeMisfitShare), 0, frames.size()};
  }
  const auto distances = pair_distances(frames);
  const std::vector<double> medians = medians_over_frames(distances);
  return {math::quantile(distance_deviations(distances, medians), kSpreadMisfitShare),
          root_mean_square(medians), frames.size()};
}

double outlier_ratio(const Array2D<Vec3>& position, const RigidCluster& cluster,
                     const Permutation& source) {
  const std::size_t count = cluster.columns.size();
  const std::vector<double> medians =
      medians_over_frames(pair_distances(complete_frames(position, cluster, source)));
  if (count <= kMinClusterSize || medians.empty()) return 0;
  std::vector<double> sum(count);  // of the distances of a marker from the others
  double total = 0;
  std::size_t pair = 0;
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = a + 1; b < count; ++b) {
      sum[a] += medians[pair];
      sum[b] += medians[pair];
      total += medians[pair++];
    }
  }
  const double largest = std::ranges::max(sum);
  const double pairs_of_others = static_cast<double>((count - 1) * (count - 2)) / 2;
  return largest / static_cast<double>(count - 1) / ((total - largest) / pairs_of_others);
}

RigidCluster with_recorded_shape(const Array2D<Vec3>& position, RigidCluster cluster) {
  const auto frames = complete_frames(position, cluster, identity_permutation(position.cols));
  const auto distances = pair_distances(frames);
  const std::vector<double> deviations =
      distance_deviations(distances, medians_over_frames(distances));
  const auto nearest = std::ranges::min_element(deviations);
  if (nearest != deviations.end()) cluster.shape = frames[nearest - deviations.begin()];
  return cluster;
}

}  // namespace morphe::imports
