#include "stages/reconstruct/reconstructed_skeleton.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/motion/arm_estimate.hpp"
#include "stages/reconstruct/arm_kinematics.hpp"
#include "stages/reconstruct/hand_from_keypoints.hpp"
#include "stages/reconstruct/skeleton_joints.hpp"
#include "stages/reconstruct/streams.hpp"

namespace morphe::reconstruct {
namespace {

constexpr double kRounding_s = 1e-9;

/// The position of an instant of the clock between two rows of a recording.
struct InterpolatedRow {
  int row = 0;
  double share = 0;  ///< share of the interval to the next row
};

std::vector<InterpolatedRow> interpolation_rows(const std::vector<double>& time,
                                                const TimeGrid& clock) {
  std::vector<InterpolatedRow> rows;
  int row = 0;
  for (int i = 0; i < clock.count; ++i) {
    const double time_s = clock.at(i);
    while (row + 1 < std::ssize(time) && time[row + 1] <= time_s + kRounding_s) ++row;
    const bool last = row + 1 >= std::ssize(time);
    const double since = time_s - time[row];
    rows.push_back({row, last || since <= kRounding_s ? 0 : since / (time[row + 1] - time[row])});
  }
  return rows;
}

void note_estimates(HumanMotion& motion) {
  if (motion.estimated.empty()) return;
  const bool arm = std::ranges::any_of(motion.estimated, [](const std::string& name) {
    return std::ranges::find(kArmPointNames, name) != kArmPointNames.end();
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
  const auto set_centre = [&](const std::string& name, std::vector<Vec3>& centres) {
    const SkeletonJoint joint = find_joint(body, "right_" + name);
    if (!joint.exists()) return;
    centres = interpolate_rows(rows, joint.position);
    if (joint.estimated) motion.estimated.push_back(name);
  };
  set_centre("shoulder", motion.shoulder);
  set_centre("elbow", motion.elbow);
  set_centre("wrist", motion.wrist);
  const bool arm_measured = motion.estimated.empty();
  if (const SkeletonJoint hand = find_joint(body, "right_hand"); hand.exists()) {
    motion.wrist_orientation = interpolate_rows(rows, hand.orientation);
    if (hand.estimated) motion.estimated.emplace_back("wrist orientation");
  }
  if (arm_measured) add_arm_angles(motion);

  const Digits digits = find_digits(body);
  std::vector<HandKeypoints> fingers(clock.count);
  for (HandKeypoints& points : fingers) points.fill(unknown_point());
  for (int i = 0; i < clock.count; ++i) fingers[i][0] = motion.wrist[i];
  bool tips_estimated = false, tips_turned = false;
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    for (int k = 0; k < 4; ++k) {
      if (!digits[finger][k].exists()) continue;
      const std::vector<Vec3> joint = interpolate_rows(rows, digits[finger][k].position);
      for (int i = 0; i < clock.count; ++i) fingers[i][keypoint_index(finger, k)] = joint[i];
    }
    const SkeletonJoint& tip = digits[finger][3];
    tips_estimated = tips_estimated || tip.estimated;
    tips_turned = tips_turned || has_orientation(tip);
    if (!tip.exists()) continue;
    const std::vector<Quat> orientation = interpolate_rows(rows, tip.orientation);
    for (int i = 0; i < clock.count; ++i) motion.tip_orientation(i, finger) = orientation[i];
  }
  set_finger_points(fingers, motion);
  if (tips_estimated) motion.estimated.emplace_back("fingertips");
  note_estimates(motion);
  const auto fitted = fit_hand(fingers, std::nullopt, clock.rate_hz);
  if (!fitted) return motion;
  add_hand_angles(*fitted, motion);
  motion.bones = fitted->bones;
  if (!tips_turned) set_tip_orientations(*fitted, motion);
  return motion;
}

}  // namespace morphe::reconstruct
