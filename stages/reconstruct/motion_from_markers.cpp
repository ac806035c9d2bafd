#include <cmath>

#include "stages/reconstruct/arm_kinematics.hpp"
#include "stages/reconstruct/gaps.hpp"
#include "stages/reconstruct/joint_centre.hpp"
#include "stages/reconstruct/marker_tips.hpp"
#include "stages/reconstruct/streams.hpp"

namespace morphe::reconstruct {
namespace {

/// Returns the hand frame: z from the wrist to the finger base, y to the thumb's side (from the
/// ulnar to the radial styloid, made orthogonal), x = y × z out of a right palm.
Eigen::Matrix3d axes_of_landmarks(const Vec3& finger_base, const Vec3& radial, const Vec3& ulnar) {
  const Vec3 z = (finger_base - (radial + ulnar) / 2).normalized();
  const Vec3 across = radial - ulnar;
  const Vec3 y = (across - z * z.dot(across)).normalized();
  Eigen::Matrix3d axes;
  axes << y.cross(z), y, z;
  return axes;
}

/// Sets the hand's orientation, carried by its cluster, or from its landmarks in every frame.
void set_hand(MarkerTrial& trial, const MarkerBody& forearm, const MarkerBody& hand,
              HumanMotion& motion) {
  // Discards the notes on the landmarks' gaps, which are reported elsewhere.
  std::vector<std::string> said;
  std::swap(said, motion.reconstruction_notes);
  const Landmark radial = make_landmark(trial, "RSPR", forearm, motion);
  const Landmark ulnar = make_landmark(trial, "RSPU", forearm, motion);
  std::swap(said, motion.reconstruction_notes);
  const Landmark base = make_landmark(trial, "RFB", hand, motion);
  const auto in_hand = [&](const Landmark& landmark) {
    return landmark_in_body(trial, landmark, hand, motion);
  };
  const Eigen::Matrix3d fixed = axes_of_landmarks(in_hand(base), in_hand(radial), in_hand(ulnar));
  const bool shown = !base.track.empty() && !radial.track.empty() && !ulnar.track.empty();
  if (!(hand.exists() && fixed.allFinite()) && !shown) {
    motion.reconstruction_notes.push_back(
        "hand: its axes need RFB, RSPR and RSPU, in the static trial or in the recording");
    return;
  }
  for (std::size_t i = 0; i < trial.clock.count; ++i) {
    const Eigen::Matrix3d world_from_hand =
        hand.exists() && fixed.allFinite()
            ? Eigen::Matrix3d(hand.world_from_body[i].linear() * fixed)
            : axes_of_landmarks(base.track[i], radial.track[i], ulnar.track[i]);
    if (!world_from_hand.allFinite()) continue;
    Quat& now = motion.wrist_orientation[i];
    now = Quat(world_from_hand).normalized();
    if (i > 0 && is_known(motion.wrist_orientation[i - 1]) &&
        now.dot(motion.wrist_orientation[i - 1]) < 0) {
      now.coeffs() *= -1;
    }
  }
}

/// Returns the lengths of upper arm and forearm in the static trial, if it shows all of their
/// landmarks: for one subject they are the same in every recording, while centres of rotation
/// differ by a centimetre.
std::optional<human::ArmLengths> static_lengths(MarkerTrial& trial,
                                                std::vector<std::string>& problems) {
  const auto at = [&](const char* marker) { return trial.static_trial.at(marker, problems); };
  const Vec3 elbow = (at("RLEP") + at("RMEP")) / 2, wrist = (at("RSPR") + at("RSPU")) / 2;
  const human::ArmLengths lengths{(elbow - at("RGTH")).norm(), (wrist - elbow).norm()};
  const bool known = std::isfinite(lengths.upper_arm) && std::isfinite(lengths.forearm);
  return known ? std::optional(lengths) : std::nullopt;
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
