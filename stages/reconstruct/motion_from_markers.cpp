#include <cmath>

#include "stages/reconstruct/arm_kinematics.hpp"
#include "stages/reconstruct/gaps.hpp"
#include "stages/reconstruct/joint_centre.hpp"
#include "stages/reconstruct/streams.hpp"

namespace morphe::reconstruct {
namespace {

/// Returns the axes of the hand: z from the wrist to the finger base; y from the ulnar to the
/// radial styloid, made orthogonal to z; x = y × z, out of a right palm.
Eigen::Matrix3d axes_of_landmarks(const Vec3& finger_base, const Vec3& radial, const Vec3& ulnar) {
  const Vec3 z = (finger_base - (radial + ulnar) / 2).normalized();
  const Vec3 across = radial - ulnar;
  const Vec3 y = (across - z * z.dot(across)).normalized();
  Eigen::Matrix3d axes;
  axes << y.cross(z), y, z;
  return axes;
}

/// Sets the hand's orientation: from its cluster, otherwise from its landmarks in every frame.
void set_hand(MarkerTrial& trial, const MarkerBody& forearm, const MarkerBody& hand,
              HumanMotion& motion) {
  // Notes on the gaps of these landmarks are discarded: joint_centre() has added them.
  HumanMotion ignored;
  const Landmark radial = make_landmark(trial, "RSPR", forearm, ignored);
  const Landmark ulnar = make_landmark(trial, "RSPU", forearm, ignored);
  const Landmark base = make_landmark(trial, "RFB", hand, motion);
  const auto in_hand = [&](const Landmark& landmark) {
    return landmark_in_body(trial, landmark, hand, motion);
  };
  const Eigen::Matrix3d axes = axes_of_landmarks(in_hand(base), in_hand(radial), in_hand(ulnar));
  const bool by_cluster = hand.exists() && axes.allFinite();
  const bool shown = !base.track.empty() && !radial.track.empty() && !ulnar.track.empty();
  if (!by_cluster && !shown) {
    motion.reconstruction_notes.push_back(
        "hand: its axes need RFB, RSPR and RSPU, in the static trial or in the recording");
    return;
  }
  for (int i = 0; i < trial.clock.count; ++i) {
    const Eigen::Matrix3d world_from_hand =
        by_cluster ? Eigen::Matrix3d(hand.world_from_body[i].linear() * axes)
                   : axes_of_landmarks(base.track[i], radial.track[i], ulnar.track[i]);
    if (!world_from_hand.allFinite()) continue;
    Quat& rotation = motion.wrist_orientation[i];
    rotation = Quat(world_from_hand).normalized();
    // The dot product with an unseen rotation is NaN.
    if (i > 0 && rotation.dot(motion.wrist_orientation[i - 1]) < 0) rotation.coeffs() *= -1;
  }
}

/// Returns the lengths of upper arm and forearm in the static trial, if it shows all of their
/// landmarks. (Centres of rotation would differ by a centimetre between a subject's recordings.)
std::optional<human::ArmLengths> static_lengths(MarkerTrial& trial,
                                                std::vector<std::string>& problems) {
  const auto mean = [&](const char* marker) { return trial.static_trial.mean(marker, problems); };
  const Vec3 elbow = (mean("RLEP") + mean("RMEP")) / 2, wrist = (mean("RSPR") + mean("RSPU")) / 2;
  const human::ArmLengths lengths{(elbow - mean("RGTH")).norm(), (wrist - elbow).norm()};
  const bool known = std::isfinite(lengths.upper_arm) && std::isfinite(lengths.forearm);
  return known ? std::optional(lengths) : std::nullopt;
}

/// Returns the vector from thumb to index marker in every frame. While one of them is hidden, the
/// vector is interpolated over the gap in the hand's frame; NaN if the hand is not seen either.
std::vector<Vec3> thumb_to_index_line(const std::vector<Vec3>& thumb,
                                      const std::vector<Vec3>& index,
                                      const std::vector<Quat>& world_from_hand) {
  const std::ptrdiff_t n = std::ssize(thumb);
  std::vector<Vec3> line(n), in_hand(n, unknown_point());
  for (int i = 0; i < n; ++i) {
    line[i] = index[i] - thumb[i];
    if (is_known(world_from_hand[i])) in_hand[i] = world_from_hand[i].conjugate() * line[i];
  }
  interpolate_unseen(in_hand);
  for (int i = 0; i < n; ++i) {
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

/// Sets the tips of thumb and index from the markers RTHUM and RFTP on their nails. Each is moved
/// towards the other onto its finger's axis; the sum of both steps is at most their distance. While
/// one of the two is hidden, the direction comes from the hand's orientation. If one is never seen,
/// the other is not moved.
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
    for (int i = 0; i < std::ssize(thumb); ++i) {
      motion.tip(i, kThumb) = thumb[i];
      motion.tip(i, kIndex) = index[i];
    }
    return;
  }
  const double thumb_step = trial.options.thumb_marker_to_axis_m;
  const double index_step = trial.options.index_marker_to_axis_m;
  const double total = thumb_step + index_step;
  const std::vector<Vec3> line = thumb_to_index_line(thumb, index, motion.wrist_orientation);
  for (int i = 0; i < std::ssize(thumb); ++i) {
    const double distance = line[i].norm();
    // Without the line a tip stays NaN: on the nail it would be a step away from those on the axis.
    const Vec3 step = distance > total ? Vec3(line[i] / distance) : Vec3(line[i] / total);
    motion.tip(i, kThumb) = thumb[i] + thumb_step * step;
    motion.tip(i, kIndex) = index[i] - index_step * step;
  }
}

}  // namespace

HumanMotion motion_from_markers(const Demonstration& demonstration,
                                const ReconstructOptions& options) {
  const MarkerStream& markers = *demonstration.streams.markers;
  MarkerTrial trial{markers, StaticTrial(demonstration.calibration.markers),
                    make_time_grid({&markers.time}, options.rate_hz), options};
  HumanMotion motion = unseen_motion(trial.clock);
  const MarkerBody girdle = make_marker_body(trial, "RSHO", false, motion);
  const MarkerBody upper_arm = make_marker_body(trial, "RUAR", true, motion);
  const MarkerBody forearm = make_marker_body(trial, "RLAR", true, motion);
  const MarkerBody hand = make_marker_body(trial, "RHAN", true, motion);

  motion.shoulder = joint_centre(trial, {"shoulder", {"RGTH"}, false}, upper_arm, girdle, motion);
  motion.elbow = joint_centre(trial, {"elbow", {"RLEP", "RMEP"}, true}, upper_arm, forearm, motion);
  motion.wrist = joint_centre(trial, {"wrist", {"RSPR", "RSPU"}, true}, forearm, hand, motion);
  enforce_bone_lengths(motion, static_lengths(trial, motion.reconstruction_notes));
  set_hand(trial, forearm, hand, motion);
  note_unseen("shoulder", motion.shoulder, motion.reconstruction_notes);
  note_unseen("elbow", motion.elbow, motion.reconstruction_notes);
  note_unseen("wrist", motion.wrist, motion.reconstruction_notes);
  set_marker_tips(trial, motion);
  add_arm_angles(motion);
  return motion;
}

}  // namespace morphe::reconstruct
