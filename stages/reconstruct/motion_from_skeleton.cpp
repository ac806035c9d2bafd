#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

#include "stages/reconstruct/arm_kinematics.hpp"
#include "stages/reconstruct/estimated_arm.hpp"
#include "stages/reconstruct/gaps.hpp"
#include "stages/reconstruct/hand_from_keypoints.hpp"
#include "stages/reconstruct/reconstructed_skeleton.hpp"
#include "stages/reconstruct/skeleton_hand.hpp"
#include "stages/reconstruct/skeleton_joints.hpp"
#include "stages/reconstruct/streams.hpp"

namespace morphe::reconstruct {
namespace {

/// Returns the length from wrist to middle fingertip, bone by bone, if all joints were seen.
std::optional<double> hand_length_of(const SkeletonJoint& wrist, const Digits& digits) {
  double length = 0;
  const SkeletonJoint* previous = &wrist;
  for (const SkeletonJoint& joint : digits[kMiddle]) {
    if (!joint.exists()) return std::nullopt;
    length += mean_length(*previous, joint);
    previous = &joint;
  }
  return std::isfinite(length) ? std::optional(length) : std::nullopt;
}

/// Returns true if there are joints with names unknown to Morphe, which may be the missing ones.
bool has_other_names(const BodyStream& body) {
  constexpr std::string_view kOurs[] = {"head", "trunk", "pelvis"};
  return std::ranges::any_of(body.names, [&](const std::string& name) {
    return !name.starts_with("right_") && !name.starts_with("left_") &&
           std::ranges::find(kOurs, name) == std::end(kOurs);
  });
}

void note_missing(const std::vector<std::pair<const char*, bool>>& joints,
                  std::vector<std::string>& problems) {
  std::vector<std::string> missing;
  for (const auto& [name, exists] : joints) {
    if (!exists) missing.push_back(fmt::format("right_{}", name));
  }
  if (missing.empty()) return;
  problems.push_back(
      fmt::format("the skeleton has no joint named {} (left_… for a left arm); if it has other "
                  "names, map them with --names or `names:`",
                  fmt::join(missing, ", ")));
}

/// Notes the fingertips that are hidden for a while.
void note_unseen_tips(HumanMotion& motion) {
  for (std::size_t finger = 0; finger < motion.tip.cols; ++finger) {
    std::vector<Vec3> track;
    for (std::size_t i = 0; i < motion.tip.rows; ++i) track.push_back(motion.tip(i, finger));
    if (never_seen(track)) continue;
    note_unseen(fmt::format("{} tip", kFingerNames[finger]), track, motion.reconstruction_notes);
  }
}

}  // namespace

HumanMotion motion_from_skeleton(const Demonstration& demonstration,
                                 const ReconstructOptions& options, const HumanOptions& human) {
  const BodyStream& body = *demonstration.streams.skeleton;
  if (body.reconstructed) return motion_from_reconstructed(body, options);
  const TimeGrid clock = make_time_grid({&body.time}, options.rate_hz);
  HumanMotion motion = unseen_motion(clock);
  const SkeletonJoint shoulder = find_joint(body, "right_shoulder"),
                      elbow = find_joint(body, "right_elbow"),
                      wrist = find_joint(body, "right_wrist"), head = find_joint(body, "head");
  const auto set = [&](const char* name, const SkeletonJoint& joint, std::vector<Vec3>& centres) {
    if (!joint.exists()) return;
    centres = resample(body.time, joint.position, clock, options);
    note_unseen(name, centres, motion.reconstruction_notes);
  };
  set("shoulder", shoulder, motion.shoulder);
  set("elbow", elbow, motion.elbow);
  set("wrist", wrist, motion.wrist);
  // A seen elbow constrains the shoulder, which is then not estimated.
  const bool estimable = (shoulder.exists() || !elbow.exists()) && wrist.exists();
  if (!estimable || has_other_names(body)) {
    note_missing(
        {{"shoulder", shoulder.exists()}, {"elbow", elbow.exists()}, {"wrist", wrist.exists()}},
        motion.reconstruction_notes);
  }
  if (shoulder.exists() && elbow.exists() && wrist.exists()) {
    enforce_bone_lengths(
        motion, human::ArmLengths{mean_length(shoulder, elbow), mean_length(elbow, wrist)});
  }
  if (!wrist.exists()) return motion;

  Digits digits = find_digits(body);
  motion.wrist_orientation = hand_orientation(body.time, find_joint(body, "right_hand"), wrist,
                                              digits, clock, options, motion);
  add_arm_angles(motion);
  if (estimable) {
    estimate_arm(
        arm_lengths_of(demonstration, human, hand_length_of(wrist, digits)), human,
        head.exists() ? resample(body.time, head.position, clock, options) : std::vector<Vec3>(),
        motion);
  }
  estimate_tips(digits, motion);
  const std::vector<HandKeypoints> fingers =
      resample_fingers(body.time, wrist, digits, clock, options, motion);
  set_finger_points(fingers, motion);
  note_unseen_tips(motion);
  if (std::ranges::none_of(digits, [](const auto& digit) { return digit[3].exists(); })) {
    motion.reconstruction_notes.push_back("the skeleton has no fingertips");
  }
  if (const auto fitted = fit_hand(fingers, std::nullopt, clock.rate_hz)) {
    add_hand_angles(*fitted, motion);
    set_tip_orientations(*fitted, motion);
  }
  return motion;
}

}  // namespace morphe::reconstruct
