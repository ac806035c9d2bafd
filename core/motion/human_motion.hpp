#pragma once

#include <iterator>
#include <string>
#include <vector>

#include "core/motion/geometry.hpp"
#include "core/motion/hand_bones.hpp"

namespace morphe {

/// Number, indices and names of the digits.
inline constexpr std::size_t kFingerCount = 5;
inline constexpr std::size_t kThumb = 0, kIndex = 1, kMiddle = 2, kRing = 3, kLittle = 4;
inline constexpr const char* kFingerNames[kFingerCount] = {"thumb", "index", "middle", "ring",
                                                           "little"};

/// Names of the human arm's angles, all zero if it hangs straight down, palm to the thigh.
inline constexpr const char* kArmAngleNames[] = {
    "shoulder_flexion",  "shoulder_abduction", "shoulder_internal_rotation", "elbow_flexion",
    "forearm_pronation", "wrist_flexion",      "wrist_radial_deviation"};
inline constexpr std::size_t kArmAngleCount = std::size(kArmAngleNames);
/// Names of the human hand's angles. All are zero for the flat hand; see core/human/hand.
inline constexpr const char* kHandAngleNames[] = {
    "thumb_rotation", "thumb_abduction",  "thumb_mcp",      "thumb_ip",         "index_abduction",
    "index_mcp",      "index_pip",        "index_dip",      "middle_abduction", "middle_mcp",
    "middle_pip",     "middle_dip",       "ring_abduction", "ring_mcp",         "ring_pip",
    "ring_dip",       "little_abduction", "little_mcp",     "little_pip",       "little_dip"};
inline constexpr std::size_t kHandAngleCount = std::size(kHandAngleNames);

/// The reconstruction residual of one quantity: the disagreement of redundant measurements.
struct Residual {
  std::string name;
  double rms_m = 0, max_m = 0;
};

/// A demonstration reconstructed on one clock, in the world frame (X right, Y forward, Z up) [m].
/// The hand frame of `wrist_orientation` has z from the wrist to the fingers, y to the thumb's side
/// and x out of the palm. Values that were not observed are NaN.
struct HumanMotion {
  std::vector<double> time;                  ///< [N] [s], uniform
  std::vector<Vec3> shoulder, elbow, wrist;  ///< [N] joint centres
  std::vector<Quat> wrist_orientation;       ///< [N] world_from_hand
  Array2D<Vec3> tip;                         ///< [N, 5] fingertips (finger's axis, not the skin)
  Array2D<Quat> tip_orientation;             ///< [N, 5]
  Array2D<Vec3> finger_joint;                ///< [N, 5] middle joint of each finger
  JointRows arm_angles;                      ///< [N, 7] kArmAngleNames [rad], or no rows
  JointRows hand_angles;                     ///< [N, 20] kHandAngleNames [rad], or no rows
  HandBones bones;                           ///< of the hand, if it was observed completely
  double hand_scale = 1;               ///< factor by which the fingers were scaled to the robot
  std::vector<std::string> estimated;  ///< names of points that were estimated, not recorded
  std::vector<Residual> residuals;
  std::vector<std::string> reconstruction_notes;  ///< sentences printed by `morphe inspect`
};

}  // namespace morphe
