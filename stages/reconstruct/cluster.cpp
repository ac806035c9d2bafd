#include "stages/reconstruct/cluster.hpp"

#include <algorithm>

#include "core/math/statistics.hpp"
#include "stages/reconstruct/gaps.hpp"

namespace morphe::reconstruct {
namespace {

constexpr std::size_t kNoMarker = -1;

/// Returns the pose of the body in one frame, without using the marker `left_out`.
Pose pose_at(const std::vector<Vec3>& shape, const std::vector<std::vector<Vec3>>& tracks,
             std::size_t frame, std::size_t left_out = kNoMarker) {
  std::vector<Vec3> now;
  for (const auto& track : tracks) now.push_back(track[frame]);
  if (left_out != kNoMarker) now[left_out] = unknown_point();
  return math::fit_rigid_transform(shape, now);
}

}  // namespace

Vec3 median_in_body(const std::vector<Pose>& world_from_body, const std::vector<Vec3>& track) {
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < track.size(); ++i) {
    places.emplace_back(world_from_body[i].inverse() * track[i]);
  }
  return math::median_point(places);
}

std::vector<Pose> fit_poses(const std::vector<Vec3>& shape,
                            const std::vector<std::vector<Vec3>>& tracks) {
  std::vector<Pose> poses;
  const std::size_t frames = tracks.empty() ? 0 : tracks.front().size();
  for (std::size_t i = 0; i < frames; ++i) poses.push_back(pose_at(shape, tracks, i));
  return poses;
}

std::vector<Vec3> median_shape(const std::vector<std::vector<Vec3>>& tracks) {
  constexpr int kMaxRounds = 3;
  std::vector<Vec3> shape(tracks.size(), unknown_point());
  const std::size_t frames = tracks.empty() ? 0 : tracks.front().size();
  std::ptrdiff_t most = 2;
  for (std::size_t i = 0; i < frames; ++i) {
    const auto shown =
        std::ranges::count_if(tracks, [&](const auto& track) { return is_known(track[i]); });
    if (shown <= most) continue;
    most = shown;
    for (std::size_t k = 0; k < tracks.size(); ++k) shape[k] = tracks[k][i];
  }
  for (int round = 0; round < kMaxRounds; ++round) {
    const std::vector<Pose> poses = fit_poses(shape, tracks);
    for (std::size_t k = 0; k < tracks.size(); ++k) shape[k] = median_in_body(poses, tracks[k]);
  }
  return shape;
}

void fill_marker_gaps(const std::vector<Vec3>& shape, std::vector<std::vector<Vec3>>& tracks,
                      std::size_t marker) {
  std::vector<Vec3>& track = tracks[marker];
  if (!is_known(shape[marker]) || std::ranges::all_of(track, [](auto& p) { return is_known(p); }))
    return;
  std::vector<Pose> world_from_body;
  std::vector<Vec3> deviation;  // in the body's frame
  for (std::size_t i = 0; i < track.size(); ++i) {
    world_from_body.push_back(pose_at(shape, tracks, i, marker));
    deviation.push_back(world_from_body[i].inverse() * track[i] - shape[marker]);
  }
  interpolate_unseen(deviation);
  for (std::size_t i = 0; i < track.size(); ++i) {
    if (is_known(track[i])) continue;
    const Vec3 slid = is_known(deviation[i]) ? deviation[i] : Vec3::Zero();
    const Vec3 carried = world_from_body[i] * (shape[marker] + slid);
    if (is_known(carried)) track[i] = carried;
  }
}

void fill_cluster_gaps(const std::vector<Vec3>& shape, std::vector<std::vector<Vec3>>& tracks) {
  std::vector<std::vector<Vec3>> completed = tracks;
  for (std::size_t k = 0; k < tracks.size(); ++k) {
    std::vector<std::vector<Vec3>> work = tracks;
    fill_marker_gaps(shape, work, k);
    completed[k] = std::move(work[k]);
  }
  tracks = std::move(completed);
}

}  // namespace morphe::reconstruct
