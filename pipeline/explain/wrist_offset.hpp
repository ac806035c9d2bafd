#pragma once

#include <array>

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::explain {

/// Changes of the robot or its path, each of which removes one of the vectors of WristOffset;
/// without regard to reach, joint limits and obstacles. A number is a sum of changes.
enum WristChange : unsigned {
  kLinksChange = 1,    ///< links are as long as the person's
  kFingersChange = 2,  ///< hand and fingers are as large and as bent as the person's
  kPalmChange = 4,     ///< the palm is turned as the person's hand
  kTipsChange = 8,     ///< the tips are at their goals
  kBaseChange = 16     ///< the base is moved by the one shift that removes most of the rest
};
inline constexpr std::size_t kWristChangeSums = 32;

/// The distance of the driven wrist W from the place at which both links would have the person's
/// directions u and f (humanlike::wrist_offset), the sum of
///   (s - S) - (L1 - l1) u - (L2 - l2) f + (W - w)
/// with the robot's shoulder S and lengths L, the person's shoulder s, lengths l and wrist w. With
/// the middle of the tips T and that of their goals G, the last vector is the sum of
///   (T - G) + (P - H) c + H (c - d),  c = P^-1 (W - T),  d = H^-1 (w - G)
/// where P and H are the rotations of the robot's palm and of the person's hand.
struct WristOffset {
  std::array<double, kWristChangeSums> after;  ///< RMS over the samples after changes [m]
  Vec3 base_shift = unknown_point();  ///< the shift of the base that removes most, base frame [m]
  /// False if the hand is not known: W - w is not taken apart, and all of it is in `fingers`.
  bool is_hand_known = false;
  /// RMS of W - w and of its three parts, in the order of the sum [m].
  double from_human = kUnknown, tips = kUnknown, palm = kUnknown, fingers = kUnknown;
  double upper_arm = kUnknown, forearm = kUnknown;  ///< the robot's lengths, means [m]
  double human_upper_arm = kUnknown, human_forearm = kUnknown;

  WristOffset() { after.fill(kUnknown); }
  double rms() const { return after[0]; }
};
/// Measures the offset over the samples of the trajectory at which both arms are known; of these,
/// if there are any, over those at which also the person's hand and the goal of a tip are known.
WristOffset wrist_offset(const robot::Robot& robot, const Plan& plan);

}  // namespace morphe::explain
