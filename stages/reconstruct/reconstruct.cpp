#include "stages/reconstruct/reconstruct.hpp"

#include "stages/reconstruct/mirror.hpp"
#include "stages/reconstruct/streams.hpp"

namespace morphe::reconstruct {

std::string validation_error(const ReconstructOptions& o) {
  if (!(o.rate_hz > 0 && o.rate_hz <= 1000)) return "rate_hz must be above 0 and at most 1000";
  if (!(o.cutoff_hz > 0 && o.cutoff_hz < 0.4 * o.rate_hz)) {
    return "cutoff_hz must lie between 0 and 0.4 rate_hz";
  }
  if (!(o.glove_rest_cutoff_hz > 0)) return "glove_rest_cutoff_hz must be positive";
  if (!(o.max_gap_s > 0)) return "max_gap_s must be positive";
  for (const double shift : {o.thumb_marker_to_axis_m, o.index_marker_to_axis_m}) {
    if (!(shift >= 0 && shift < 0.05)) return "marker_to_axis must lie between 0 and 0.05 m";
  }
  return "";
}

std::string validation_error(const HumanOptions& o) {
  if (o.stature_m && !(*o.stature_m > 0.5 && *o.stature_m < 2.5)) {
    return "stature_m must lie between 0.5 and 2.5 m";
  }
  for (const auto& length : {o.upper_arm, o.forearm}) {
    if (length && !(*length > 0)) return "upper_arm and forearm must be positive";
  }
  if (!(o.max_limit_violation_m > 0)) return "max_limit_violation_m must be positive";
  if (!(o.max_reach_share > 0 && o.max_reach_share < 1))
    return "max_reach_share must lie between 0 and 1";
  return "";
}

HumanMotion unseen_motion(const TimeGrid& clock) {
  HumanMotion motion;
  const std::size_t n = clock.count;
  for (std::size_t i = 0; i < n; ++i) motion.time.push_back(clock.at(i));
  motion.shoulder = motion.elbow = motion.wrist = std::vector<Vec3>(n, unknown_point());
  motion.wrist_orientation = std::vector<Quat>(n, unknown_rotation());
  motion.tip = motion.finger_joint = Array2D<Vec3>(n, kFingerCount, unknown_point());
  motion.tip_orientation = Array2D<Quat>(n, kFingerCount, unknown_rotation());
  return motion;
}

HumanMotion reconstruct(const Demonstration& demonstration, const ReconstructOptions& options,
                        const HumanOptions& human) {
  if (demonstration.hand == Side::left) {
    HumanMotion motion = reconstruct(mirror_image(demonstration), options, human);
    motion.reconstruction_notes.push_back("a left hand: mirrored at X = 0 into a right hand");
    return motion;
  }
  // If there are tracked joints, markers belong to objects.
  if (demonstration.streams.markers && !demonstration.streams.sensors &&
      !demonstration.streams.skeleton) {
    return motion_from_markers(demonstration, options);
  }
  const auto& hand = demonstration.streams.hand;
  if (demonstration.streams.sensors || (hand && hand->kind == HandKind::glove)) {
    return motion_from_sensors(demonstration, options, human);
  }
  if (demonstration.streams.skeleton) return motion_from_skeleton(demonstration, options, human);
  if (hand && hand->kind == HandKind::keypoints) return motion_from_hand(demonstration, options);
  HumanMotion nothing = unseen_motion({});
  nothing.reconstruction_notes.push_back(
      demonstration.streams.arm_angles
          ? "joint angles only: the dimensions of the body are unknown, so no arm is reconstructed"
          : "neither markers nor tracked bodies: no arm can be reconstructed");
  return nothing;
}

}  // namespace morphe::reconstruct
