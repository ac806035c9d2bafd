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
  double time = 0;  ///< [s]
  Vec3 elbow = unknown_point(), wrist = unknown_point();
  Quat hand = unknown_rotation();
  std::array<Vec3, kFingerCount> tip;  ///< fingertips, unknown if not recorded

  HumanPose() { tip.fill(unknown_point()); }
};
/// The poses of one series, in order of time.
using HumanPoses = std::vector<HumanPose>;

/// Returns one series per movement of the recordings, as performed by an arm of other lengths:
/// upper arm and forearm keep their directions, the hand its pose relative to the wrist. Frames are
/// about `step_s` apart. Those in which shoulder, elbow, wrist or hand were not seen are left out,
/// as are movements without frames.
std::vector<HumanPoses> arm_poses(const std::filesystem::path& manifest,
                                  const human::ArmLengths& lengths, double step_s);

/// Returns one series per recording of a hand without an arm: the recorded finger angles, applied
/// to a hand of another size (core/human/hand), in its own frame. The wrist is the origin, and the
/// elbow is unknown. Frames are about `step_s` apart; those without all angles are left out.
std::vector<HumanPoses> hand_poses(const std::filesystem::path& manifest,
                                   const human::HandSize& size, double step_s);

}  // namespace morphe::study
