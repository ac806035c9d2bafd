#pragma once

#include <iterator>
#include <string>
#include <vector>

#include "core/motion/geometry.hpp"
#include "core/motion/hand_bones.hpp"

namespace morphe {

inline constexpr std::size_t kFingers = 5;  ///< thumb, index, middle, ring, little
inline constexpr std::size_t kThumb = 0, kIndex = 1, kMiddle = 2, kRing = 3, kLittle = 4;
inline constexpr const char* kFingerNames[kFingers] = {"thumb", "index", "middle", "ring",
                                                       "little"};

/// The human arm's angles: zero hangs straight down, the palm to the thigh; see core/human/arm.
inline constexpr const char* kArmAngleNames[] = {
    "shoulder_flexion",  "shoulder_abduction", "shoulder_internal_rotation", "elbow_flexion",
    "forearm_pronation", "wrist_flexion",      "wrist_radial_deviation"};
inline constexpr std::size_t kArmAngles = std::size(kArmAngleNames);
/// The human hand's: zero is the flat hand; see core/human/hand.
inline constexpr const char* kHandAngleNames[] = {
    "thumb_rotation", "thumb_abduction",  "thumb_mcp",      "thumb_ip",         "index_abduction",
    "index_mcp",      "index_pip",        "index_dip",      "middle_abduction", "middle_mcp",
    "middle_pip",     "middle_dip",       "ring_abduction", "ring_mcp",         "ring_pip",
    "ring_dip",       "little_abduction", "little_mcp",     "little_pip",       "little_dip"};
inline constexpr std::size_t kHandAngles = std::size(kHandAngleNames);

/// How well one quantity was rebuilt: what the redundant measurements disagree by.
struct Residual {
  std::string name;
  double rms_m = 0, max_m = 0;
};

/// A demonstration rebuilt on one clock, in the world frame (X right, Y forward, Z up) [m].
/// The hand frame of `wrist_orientation`: z from the wrist to the fingers, y to the thumb's side,
/// x out of the palm. NaN = not seen.
struct HumanMotion {
  std::vector<double> time;                  ///< [N] [s], uniform
  std::vector<Vec3> shoulder, elbow, wrist;  ///< [N] joint centres
  std::vector<Quat> wrist_orientation;       ///< [N] world_from_hand
  Table<Vec3> tip;                           ///< [N, 5] fingertips (finger's axis, not the skin)
  Table<Quat> tip_orientation;               ///< [N, 5]
  Table<Vec3> finger_joint;                  ///< [N, 5] middle joint of each finger
  JointRows arm_angles;                      ///< [N, 7] kArmAngleNames [rad], or no rows
  JointRows hand_angles;                     ///< [N, 20] kHandAngleNames [rad], or no rows
  HandBones bones;                           ///< of the hand, if it was seen whole
  double hand_scale = 1;  ///< what distances of the fingers were multiplied by, for a robot's hand
  std::vector<std::string> estimated;  ///< what was not recorded but estimated
  std::vector<Residual> residuals;
  std::vector<std::string> problems;  ///< sentences for `morphe inspect`
};

}  // namespace morphe
