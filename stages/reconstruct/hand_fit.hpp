#pragma once

#include <array>
#include <vector>

#include "pipeline/human/hand.hpp"
#include "stages/reconstruct/hand_shape.hpp"

namespace morphe {

/// Finds the angles of a hand, within its limits, that bring its joints and tips nearest to given
/// points: for each finger by itself,
///   min over its 4 angles of sum_k |x_k(q) - p_k|^2,  k = its two joints beyond the base, its tip,
/// by Levenberg-Marquardt from the last frame's angles and from a hand half closed, whichever comes
/// nearer. The palm's arch stays flat: it is part of where the knuckles are.
class HandFit {
 public:
  explicit HandFit(RobotTable hand);
  /// Points in the hand frame. A finger with a point unseen has NaN angles.
  HandAngles operator()(const HandKeypoints& in_hand);

 private:
  struct Solution {
    std::array<double, kHandAngles> joint{};
    std::array<double, kFingers> error{};  ///< [m^2], NaN = finger unseen
  };
  Solution solve(const HandKeypoints& in_hand, std::array<double, kHandAngles> joint);

  RobotTable hand_;
  std::array<double, kHandAngles> half_closed_{}, last_{};
  std::vector<Pose> frames_;  ///< scratch
};

}  // namespace morphe
