#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "core/human/arm.hpp"
#include "core/human/hand.hpp"
#include "core/motion/human_motion.hpp"

namespace morphe::study {

/// A pose of a human arm and hand with the shoulder at the origin (X right, Y forward, Z up) [m].
struct HumanPose {
  /// The time in the recording [s].
  double time = 0;
  /// The elbow and the wrist [m].
  Vec3 elbow = unknown_point(), wrist = unknown_point();
  /// The orientation of the hand.
  Quat hand = unknown_rotation();
  /// Fingertips, unknown if not recorded.
  std::array<Vec3, kFingerCount> tip;

  HumanPose() { tip.fill(unknown_point()); }
};
/// The poses of one series, in order of time.
using HumanPoses = std::vector<HumanPose>;

/// Returns the movements of recordings as performed by an arm of other lengths: upper arm and
/// forearm keep their directions, the hand keeps its pose relative to the wrist. Frames are about
/// `step_s` apart and include only those in which shoulder, elbow, wrist and hand were seen. There
/// is one series per movement.
std::vector<HumanPoses> arm_poses(const std::filesystem::path& manifest,
                                  const human::ArmLengths& lengths, double step_s);

/// Returns whole recordings of hands alone: the recorded finger angles, applied to a hand of
/// another size (core/human/hand), in its own frame. The origin is the wrist; there is no elbow.
std::vector<HumanPoses> hand_poses(const std::filesystem::path& manifest,
                                   const human::HandSize& size, double step_s);

}  // namespace morphe::study
