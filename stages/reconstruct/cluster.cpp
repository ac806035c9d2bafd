#include "stages/reconstruct/cluster.hpp"

#include <algorithm>
#include <optional>

#include "core/math/statistics.hpp"
#include "stages/reconstruct/gaps.hpp"

namespace morphe::reconstruct {
namespace {

Pose pose_at(const std::vector<Vec3>& shape, const ClusterTracks& tracks, std::size_t frame,
             std::optional<std::size_t> left_out = {}) {
  std::vector<Vec3> markers;
  for (const auto& track : tracks) markers.push_back(track[frame]);
  if (left_out) markers[*left_out] = unknown_point();
  return math::fit_rigid_transform(shape, markers);
}

}  // namespace

Vec3 median_in_body(const std::vector<Pose>& world_from_body, const std::vector<Vec3>& track) {
  std::vector<Vec3> in_body;
  for (int i = 0; i < std::ssize(track); ++i) {
    in_body.emplace_back(world_from_body[i].inverse() * track[i]);
  }
  return math::median_point(in_body);
}

std::vector<Pose> fit_poses(const std::vector<Vec3>& shape, const ClusterTracks& tracks) {
  std::vector<Pose> poses;
  const std::ptrdiff_t frames = tracks.empty() ? 0 : std::ssize(tracks.front());
  for (int i = 0; i < frames; ++i) poses.push_back(pose_at(shape, tracks, i));
  return poses;
}

std::vector<Vec3> median_shape(const ClusterTracks& tracks) {
  constexpr int kMaxRounds = 3;
  std::vector<Vec3> shape(tracks.size(), unknown_point());
  const std::ptrdiff_t frames = tracks.empty() ? 0 : std::ssize(tracks.front());
  std::ptrdiff_t max_shown = 2;
  for (int i = 0; i < frames; ++i) {
    const auto shown =
        std::ranges::count_if(tracks, [&](const auto& track) { return is_known(track[i]); });
    if (shown <= max_shown) continue;
    max_shown = shown;
    for (int k = 0; k < std::ssize(tracks); ++k) shape[k] = tracks[k][i];
  }
  for (int round = 0; round < kMaxRounds; ++round) {
    const std::vector<Pose> poses = fit_poses(shape, tracks);
    for (int k = 0; k < std::ssize(tracks); ++k) shape[k] = median_in_body(poses, tracks[k]);
  }
  return shape;
}

void fill_marker_gaps(const std::vector<Vec3>& shape, ClusterTracks& tracks, std::size_t marker) {
  std::vector<Vec3>& track = tracks[marker];
  const auto seen = [](const Vec3& point) { return is_known(point); };
  if (!is_known(shape[marker]) || std::ranges::all_of(track, seen)) return;
  std::vector<Pose> world_from_body;
  std::vector<Vec3> deviation;  // in the body's frame
  for (int i = 0; i < std::ssize(track); ++i) {
    world_from_body.push_back(pose_at(shape, tracks, i, marker));
    deviation.push_back(world_from_body[i].inverse() * track[i] - shape[marker]);
  }
  interpolate_unseen(deviation);
  for (int i = 0; i < std::ssize(track); ++i) {
    if (is_known(track[i])) continue;
    const Vec3 offset = is_known(deviation[i]) ? deviation[i] : Vec3::Zero();
    const Vec3 position = world_from_body[i] * (shape[marker] + offset);
    if (is_known(position)) track[i] = position;
  }
}

void fill_cluster_gaps(const std::vector<Vec3>& shape, ClusterTracks& tracks) {
  ClusterTracks completed = tracks;
  for (int k = 0; k < std::ssize(tracks); ++k) {
    ClusterTracks filled = tracks;
    fill_marker_gaps(shape, filled, k);
    completed[k] = std::move(filled[k]);
  }
  tracks = std::move(completed);
}

}  // namespace morphe::reconstruct
