#include "stages/reconstruct/cluster.hpp"

#include <optional>

namespace morphe {
namespace {

/// Deviation of one marker from where the others carry it, in the static trial's frame.
struct Deviation {
  std::size_t frame;
  Vec3 in_static;
};

void complete_marker(const std::vector<Vec3>& still, std::vector<std::vector<Vec3>>& tracks,
                     std::size_t marker) {
  const std::size_t frames = tracks[marker].size();
  const auto carried_by_others = [&](std::size_t frame) {
    std::vector<Vec3> now;
    for (const auto& track : tracks) now.push_back(track[frame]);
    now[marker] = unseen_point();
    return fit_rigid(still, now);
  };
  const auto deviation_at = [&](std::size_t frame, const Pose& world_from_static) {
    return Deviation{frame, world_from_static.inverse() * tracks[marker][frame] - still[marker]};
  };
  std::optional<Deviation> before;
  for (std::size_t i = 0; i < frames; ++i) {
    if (seen(tracks[marker][i])) continue;
    std::size_t end = i;
    while (end < frames && !seen(tracks[marker][end])) ++end;
    before.reset();
    if (i > 0) {
      if (const Pose pose = carried_by_others(i - 1); pose.matrix().allFinite()) {
        before = deviation_at(i - 1, pose);
      }
    }
    std::optional<Deviation> after;
    if (end < frames) {
      if (const Pose pose = carried_by_others(end); pose.matrix().allFinite()) {
        after = deviation_at(end, pose);
      }
    }
    for (; i < end; ++i) {
      const Pose pose = carried_by_others(i);
      Vec3 deviation = Vec3::Zero();
      if (before && after) {
        const double share = static_cast<double>(i - before->frame) /
                             static_cast<double>(after->frame - before->frame);
        deviation = (1 - share) * before->in_static + share * after->in_static;
      } else if (before || after) {
        deviation = before ? before->in_static : after->in_static;
      }
      if (pose.matrix().allFinite()) tracks[marker][i] = pose * (still[marker] + deviation);
    }
  }
}

}  // namespace

void complete_cluster(const std::vector<Vec3>& still, std::vector<std::vector<Vec3>>& tracks) {
  std::vector<std::vector<Vec3>> completed = tracks;
  for (std::size_t k = 0; k < tracks.size(); ++k) {
    std::vector<std::vector<Vec3>> work = tracks;  // only what was recorded carries a marker
    if (seen(still[k])) complete_marker(still, work, k);
    completed[k] = std::move(work[k]);
  }
  tracks = std::move(completed);
}

}  // namespace morphe
