#include <cmath>

#include "stages/reconstruct/arm_chain.hpp"
#include "stages/reconstruct/gaps.hpp"
#include "stages/reconstruct/joint_centre.hpp"
#include "stages/reconstruct/marker_tips.hpp"
#include "stages/reconstruct/streams.hpp"

namespace morphe::reconstruct {
namespace {

/// Hand frame: z from the wrist to the finger base, y to the thumb's side (from the ulnar to the
/// radial styloid, made orthogonal), x = y × z out of a right palm.
Eigen::Matrix3d axes_of_landmarks(const Vec3& finger_base, const Vec3& radial, const Vec3& ulnar) {
  const Vec3 z = (finger_base - (radial + ulnar) / 2).normalized();
  const Vec3 across = radial - ulnar;
  const Vec3 y = (across - z * z.dot(across)).normalized();
  Eigen::Matrix3d axes;
  axes << y.cross(z), y, z;
  return axes;
}

/// The hand's orientation: carried by its cluster, or from its landmarks in every frame.
void set_hand(MarkerTrial& trial, const MarkerBody& forearm, const MarkerBody& hand,
              HumanMotion& motion) {
  std::vector<std::string> said;  // of the landmarks' gaps, elsewhere
  std::swap(said, motion.problems);
  const Landmark radial = landmark_of(trial, "RSPR", forearm, motion);
  const Landmark ulnar = landmark_of(trial, "RSPU", forearm, motion);
  std::swap(said, motion.problems);
  const Landmark base = landmark_of(trial, "RFB", hand, motion);
  const auto in_hand = [&](const Landmark& landmark) {
    return landmark_in_body(trial, landmark, hand, motion);
  };
  const Eigen::Matrix3d fixed = axes_of_landmarks(in_hand(base), in_hand(radial), in_hand(ulnar));
  const bool shown = !base.track.empty() && !radial.track.empty() && !ulnar.track.empty();
  if (!(hand.exists() && fixed.allFinite()) && !shown) {
    motion.problems.push_back(
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
    if (i > 0 && seen(motion.wrist_orientation[i - 1]) &&
        now.dot(motion.wrist_orientation[i - 1]) < 0) {
      now.coeffs() *= -1;
    }
  }
}

/// Upper arm and forearm of the static trial, if it shows all of their landmarks: of one subject
/// they are the same in every recording, while pivots differ by a centimetre.
std::optional<human::ArmLengths> static_lengths(MarkerTrial& trial,
                                                std::vector<std::string>& problems) {
  const auto at = [&](const char* marker) { return trial.still.at(marker, problems); };
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
                    clock_over({&markers.time}, options.rate_hz), options};
  HumanMotion motion = unseen_motion(trial.clock);
  const MarkerBody girdle = body_of(trial, "RSHO", false, motion);
  const MarkerBody upper_arm = body_of(trial, "RUAR", true, motion);
  const MarkerBody forearm = body_of(trial, "RLAR", true, motion);
  const MarkerBody hand = body_of(trial, "RHAN", true, motion);

  motion.shoulder = joint_centre(trial, {"shoulder", {"RGTH"}, false}, upper_arm, girdle, motion);
  motion.elbow = joint_centre(trial, {"elbow", {"RLEP", "RMEP"}, true}, upper_arm, forearm, motion);
  motion.wrist = joint_centre(trial, {"wrist", {"RSPR", "RSPU"}, true}, forearm, hand, motion);
  keep_bone_lengths(motion, static_lengths(trial, motion.problems));
  set_hand(trial, forearm, hand, motion);
  note_unseen("shoulder", motion.shoulder, motion.problems);
  note_unseen("elbow", motion.elbow, motion.problems);
  note_unseen("wrist", motion.wrist, motion.problems);
  set_marker_tips(trial, motion);
  add_arm_angles(motion);
  return motion;
}

}  // namespace morphe::reconstruct
