#include "stages/reconstruct/marker_tips.hpp"

#include "stages/reconstruct/gaps.hpp"

namespace morphe::reconstruct {
namespace {

/// Returns the vector from thumb to index marker in every frame. While one of them is hidden, the
/// line turns with the hand, interpolated in the hand's frame between its values before and after
/// the gap; NaN if the hand is not seen either.
std::vector<Vec3> thumb_to_index_line(const std::vector<Vec3>& thumb,
                                      const std::vector<Vec3>& index,
                                      const std::vector<Quat>& world_from_hand) {
  const std::size_t n = thumb.size();
  std::vector<Vec3> line(n), in_hand(n, unknown_point());
  for (std::size_t i = 0; i < n; ++i) {
    line[i] = index[i] - thumb[i];
    if (is_known(world_from_hand[i])) in_hand[i] = world_from_hand[i].conjugate() * line[i];
  }
  interpolate_unseen(in_hand);
  for (std::size_t i = 0; i < n; ++i) {
    if (!is_known(line[i]) && is_known(world_from_hand[i]))
      line[i] = world_from_hand[i] * in_hand[i];
  }
  return line;
}

std::vector<Vec3> tip_marker(const MarkerTrial& trial, const std::string& name,
                             std::vector<std::string>& problems) {
  const MarkerStream& markers = trial.markers;
  const std::vector<Vec3> track = marker_track(markers, name);
  if (!never_seen(track)) {
    note_gaps(name, markers.time, track, track, trial.options.max_gap_s, problems);
  }
  return resample(markers.time, track, trial.clock, trial.options);
}

}  // namespace

void set_marker_tips(const MarkerTrial& trial, HumanMotion& motion) {
  const auto thumb = tip_marker(trial, "RTHUM", motion.reconstruction_notes);
  const auto index = tip_marker(trial, "RFTP", motion.reconstruction_notes);
  const bool no_thumb = never_seen(thumb), no_index = never_seen(index);
  if (no_thumb && no_index) {
    motion.reconstruction_notes.push_back("no fingertips: neither RTHUM nor RFTP was seen");
    return;
  }
  if (no_thumb || no_index) {
    motion.reconstruction_notes.push_back(
        "only one fingertip was seen: its marker is assumed to be on the finger's axis");
    for (std::size_t i = 0; i < thumb.size(); ++i) {
      motion.tip(i, kThumb) = thumb[i];
      motion.tip(i, kIndex) = index[i];
    }
    return;
  }
  const double thumb_step = trial.options.thumb_marker_to_axis_m;
  const double index_step = trial.options.index_marker_to_axis_m;
  const double total = thumb_step + index_step;
  const std::vector<Vec3> line = thumb_to_index_line(thumb, index, motion.wrist_orientation);
  for (std::size_t i = 0; i < thumb.size(); ++i) {
    const double distance = line[i].norm();
    // Without the line a tip stays NaN: its position on the nail would be a step relative to those
    // on the axis.
    const Vec3 step = distance > total ? Vec3(line[i] / distance) : Vec3(line[i] / total);
    motion.tip(i, kThumb) = thumb[i] + thumb_step * step;
    motion.tip(i, kIndex) = index[i] - index_step * step;
  }
}

}  // namespace morphe::reconstruct
