#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "core/human/arm.hpp"
#include "core/human/hand.hpp"
#include "core/motion/human_motion.hpp"

namespace morphe::study {

/// A human arm and hand whose shoulder is the origin (X right, Y forward, Z up) [m].
struct HumanPose {
  double time = 0;
  Vec3 elbow = unseen_point(), wrist = unseen_point();
  Quat hand = unseen_rotation();
  std::array<Vec3, kFingers> tip;  ///< unseen where it was not recorded

  HumanPose() { tip.fill(unseen_point()); }
};
using HumanPoses = std::vector<HumanPose>;

/// The movements of recordings, as an arm of other lengths makes them: upper arm and forearm keep
/// their directions, the hand its pose at the wrist. Frames about `step_s` apart in which shoulder,
/// elbow, wrist and hand were seen; one series a movement.
std::vector<HumanPoses> arm_poses(const std::filesystem::path& manifest,
                                  const human::ArmLengths& lengths, double step_s);

/// Hands alone, whole recordings: the recorded angles of the fingers, made by a hand of another
/// size (core/human/hand), in its own frame. The wrist is the origin; there is no elbow.
std::vector<HumanPoses> hand_poses(const std::filesystem::path& manifest,
                                   const human::HandSize& size, double step_s);

}  // namespace morphe::study
