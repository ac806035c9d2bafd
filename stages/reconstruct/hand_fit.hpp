#pragma once

#include <array>
#include <vector>

#include "core/human/hand.hpp"
#include "stages/reconstruct/hand_shape.hpp"

namespace morphe::reconstruct {

/// Finds the angles of a hand, within its limits, that bring its joints and tips nearest to given
/// points, frame after frame: for each finger by itself,
///   min over its 4 angles of sum_k |x_k(q) - p_k|^2 + (5 mm)^2 |q - q_last|^2,
/// k = its two joints beyond the base and its tip, by Levenberg-Marquardt from the last frame's
/// angles, no angle further from them than `most_step`. What the points hardly tell thus stays what
/// it was. A finger that was not seen begins half closed, and what it was counts only from its
/// second frame on. The palm's arch stays flat: it is part of where the knuckles are.
class HandFit {
 public:
  HandFit(RobotTable hand, double most_step);
  /// Points in the hand frame. A finger with a point unseen has NaN angles.
  human::HandAngles operator()(const HandKeypoints& in_hand);

 private:
  static constexpr std::size_t kJoints = 4;  ///< of each finger
  using Angles = Eigen::Vector4d;
  struct Finger {
    Angles lower, upper, last;
    std::array<std::size_t, kJoints> frames{};  ///< of its joints
    Vec3 tip_in_last = Vec3::Zero();
    bool followed = false;  ///< was seen in the last frame
  };
  struct Task;
  void start(const HandKeypoints& in_hand, std::array<Task, kFingers>& tasks) const;
  void descend(const HandKeypoints& in_hand, std::array<Task, kFingers>& tasks);

  RobotTable hand_;
  double most_step_;
  std::array<Finger, kFingers> fingers_;
  std::vector<Pose> frames_;  ///< scratch
};

}  // namespace morphe::reconstruct
