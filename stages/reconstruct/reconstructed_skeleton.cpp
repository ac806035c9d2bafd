#include "stages/reconstruct/reconstructed_skeleton.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/motion/arm_estimate.hpp"
#include "stages/reconstruct/arm_kinematics.hpp"
#include "stages/reconstruct/hand_from_keypoints.hpp"
#include "stages/reconstruct/skeleton_joints.hpp"
#include "stages/reconstruct/streams.hpp"

namespace morphe::reconstruct {
namespace {

constexpr double kSameInstant_s = 1e-9;

/// The position of an instant of the clock between two rows of a recording.
struct InterpolatedRow {
  std::size_t row = 0;
  double share = 0;  ///< share of the interval to the next row
};

std::vector<InterpolatedRow> interpolation_rows(const std::vector<double>& time,
                                                const TimeGrid& clock) {
  std::vector<InterpolatedRow> rows;
  std::size_t row = 0;
  for (std::size_t i = 0; i < clock.count; ++i) {
    const double now = clock.at(i);
    while (row + 1 < time.size() && time[row + 1] <= now + kSameInstant_s) ++row;
    const bool last = row + 1 >= time.size();
    const double since = now - time[row];
    rows.push_back(
        {row, last || since <= kSameInstant_s ? 0 : since / (time[row + 1] - time[row])});
  }
  return rows;
}

/// Adds a note on estimated joints, which are marked by their confidence.
void note_estimates(HumanMotion& motion) {
  if (motion.estimated.empty()) return;
  const bool arm = std::ranges::any_of(motion.estimated, [](const std::string& what) {
    return std::ranges::find(kArmPointNames, what) != kArmPointNames.end();
  });
  motion.reconstruction_notes.push_back(fmt::format(
      "estimated during reconstruction, not recorded: {}{}", fmt::join(motion.estimated, ", "),
      arm ? "; humanlikeness of the arm is relative to an estimate" : ""));
}

std::vector<Vec3> interpolate_rows(const std::vector<InterpolatedRow>& rows,
                                   const std::vector<Vec3>& values) {
  std::vector<Vec3> result;
  for (const auto& [row, share] : rows) {
    result.push_back(share == 0 ? values[row]
                                : Vec3(values[row] + share * (values[row + 1] - values[row])));
  }
  return result;
}

std::vector<Quat> interpolate_rows(const std::vector<InterpolatedRow>& rows,
                                   const std::vector<Quat>& values) {
  std::vector<Quat> result;
  for (const auto& [row, share] : rows) {
    const bool both = share != 0 && is_known(values[row]) && is_known(values[row + 1]);
    result.push_back(both         ? values[row].slerp(share, values[row + 1])
                     : share == 0 ? values[row]
                                  : unknown_rotation());
  }
  return result;
}

}  // namespace

HumanMotion motion_from_reconstructed(const BodyStream& body, const ReconstructOptions& options) {
  const TimeGrid clock = make_time_grid({&body.time}, options.rate_hz);
  HumanMotion motion = unseen_motion(clock);
  const std::vector<InterpolatedRow> rows = interpolation_rows(body.time, clock);
  const auto place = [&](const char* name, const char* called, std::vector<Vec3>& centres) {
    const SkeletonJoint joint = find_joint(body, name);
    if (!joint.exists()) return;
    centres = interpolate_rows(rows, joint.position);
    if (joint.estimated) motion.estimated.emplace_back(called);
  };
  place("right_shoulder", "shoulder", motion.shoulder);
  place("right_elbow", "elbow", motion.elbow);
  place("right_wrist", "wrist", motion.wrist);
  const bool arm_measured = motion.estimated.empty();
  if (const SkeletonJoint hand = find_joint(body, "right_hand"); hand.exists()) {
    motion.wrist_orientation = interpolate_rows(rows, hand.orientation);
    if (hand.estimated) motion.estimated.emplace_back("wrist orientation");
  }
  if (arm_measured) add_arm_angles(motion);

  const Digits digits = find_digits(body);
  std::vector<HandKeypoints> fingers(clock.count);
  for (HandKeypoints& points : fingers) points.fill(unknown_point());
  for (std::size_t i = 0; i < clock.count; ++i) fingers[i][0] = motion.wrist[i];
  bool tips_estimated = false, tips_turned = false;
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    for (std::size_t j = 0; j < 4; ++j) {
      if (!digits[finger][j].exists()) continue;
      const std::vector<Vec3> here = interpolate_rows(rows, digits[finger][j].position);
      for (std::size_t i = 0; i < clock.count; ++i) fingers[i][keypoint_index(finger, j)] = here[i];
    }
    const SkeletonJoint& tip = digits[finger][3];
    tips_estimated = tips_estimated || tip.estimated;
    tips_turned = tips_turned || has_orientation(tip);
    const std::vector<Quat> turned = tip.exists()
                                         ? interpolate_rows(rows, tip.orientation)
                                         : std::vector<Quat>(clock.count, unknown_rotation());
    for (std::size_t i = 0; i < clock.count; ++i) {
      motion.tip(i, finger) = fingers[i][keypoint_index(finger, 3)];
      motion.finger_joint(i, finger) = fingers[i][keypoint_index(finger, 1)];
      motion.tip_orientation(i, finger) = turned[i];
    }
  }
  if (tips_estimated) motion.estimated.emplace_back("fingertips");
  note_estimates(motion);
  const auto fitted = fit_hand(fingers, std::nullopt, clock.rate_hz);
  if (!fitted) return motion;
  add_hand_angles(*fitted, motion);
  motion.bones = fitted->bones;
  for (std::size_t i = 0; !tips_turned && i < clock.count; ++i) {
    for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
      motion.tip_orientation(i, finger) =
          motion.wrist_orientation[i] * fitted->tip_orientation(i, finger);
    }
  }
  return motion;
}

}  // namespace morphe::reconstruct
