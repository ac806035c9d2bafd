#include "stages/reconstruct/marker_tips.hpp"

#include "stages/reconstruct/gaps.hpp"

namespace morphe::reconstruct {
namespace {

/// From thumb to index marker in every frame. Where one of them is hidden the line turns with the
/// hand, from what it was in the hand's frame before the gap to what it is after; NaN where the
/// hand is not seen either.
std::vector<Vec3> line_of_tips(const std::vector<Vec3>& thumb, const std::vector<Vec3>& index,
                               const std::vector<Quat>& world_from_hand) {
  const std::size_t n = thumb.size();
  std::vector<Vec3> line(n), in_hand(n, unseen_point());
  for (std::size_t i = 0; i < n; ++i) {
    line[i] = index[i] - thumb[i];
    if (seen(world_from_hand[i])) in_hand[i] = world_from_hand[i].conjugate() * line[i];
  }
  interpolate_unseen(in_hand);
  for (std::size_t i = 0; i < n; ++i) {
    if (!seen(line[i]) && seen(world_from_hand[i])) line[i] = world_from_hand[i] * in_hand[i];
  }
  return line;
}

std::vector<Vec3> tip_marker(const MarkerTrial& trial, const std::string& name,
                             std::vector<std::string>& problems) {
  const MarkerStream& markers = trial.markers;
  const std::vector<Vec3> track = track_of(markers, name);
  if (!never_seen(track)) {
    note_gaps(name, markers.time, track, track, trial.options.max_gap_s, problems);
  }
  return on_clock(markers.time, track, trial.clock, trial.options);
}

}  // namespace

void set_marker_tips(const MarkerTrial& trial, HumanMotion& motion) {
  const auto thumb = tip_marker(trial, "RTHUM", motion.problems);
  const auto index = tip_marker(trial, "RFTP", motion.problems);
  const bool no_thumb = never_seen(thumb), no_index = never_seen(index);
  if (no_thumb && no_index) {
    motion.problems.push_back("no fingertip: neither RTHUM nor RFTP was seen");
    return;
  }
  if (no_thumb || no_index) {
    motion.problems.push_back("one tip alone: its marker is taken for the finger's axis");
    for (std::size_t i = 0; i < thumb.size(); ++i) {
      motion.tip(i, kThumb) = thumb[i];
      motion.tip(i, kIndex) = index[i];
    }
    return;
  }
  const double thumb_step = trial.options.thumb_marker_to_axis_m;
  const double index_step = trial.options.index_marker_to_axis_m;
  const double total = thumb_step + index_step;
  const std::vector<Vec3> line = line_of_tips(thumb, index, motion.wrist_orientation);
  for (std::size_t i = 0; i < thumb.size(); ++i) {
    const double distance = line[i].norm();
    // Without the line a tip stays NaN: on the nail it would be a step beside those on the axis.
    const Vec3 step = distance > total ? Vec3(line[i] / distance) : Vec3(line[i] / total);
    motion.tip(i, kThumb) = thumb[i] + thumb_step * step;
    motion.tip(i, kIndex) = index[i] - index_step * step;
  }
}

}  // namespace morphe::reconstruct
