#pragma once

#include <string>
#include <vector>

#include "pipeline/motion/geometry.hpp"

namespace morphe {

inline constexpr std::size_t kFingers = 5;  ///< thumb, index, middle, ring, little
inline constexpr const char* kFingerNames[kFingers] = {"thumb", "index", "middle", "ring",
                                                       "little"};

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
  std::vector<std::string> estimated;        ///< what was not recorded but estimated
  std::vector<Residual> residuals;
  std::vector<std::string> problems;  ///< sentences for `morphe inspect`
};

}  // namespace morphe
