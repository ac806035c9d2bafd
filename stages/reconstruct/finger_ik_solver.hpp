#pragma once

#include <array>
#include <vector>

#include "core/human/hand.hpp"
#include "stages/reconstruct/hand_shape.hpp"

namespace morphe::reconstruct {

/// Solves the inverse kinematics of a hand, frame after frame: the angles within its limits that
/// bring its joints and tips nearest to given points. For each finger by itself it minimises
///   min over its 4 angles of sum_k |x_k(q) - p_k|^2 + (5 mm)^2 |q - q_last|^2,
/// k = its two joints beyond the base and its tip, by Levenberg-Marquardt from the last frame's
/// angles, with no angle further from them than `most_step`. Thus angles that the points hardly
/// determine stay constant. A finger that was not seen starts half closed, and the term of its last
/// angles is used only from its second frame on. The palm's arch stays flat: it is part of the
/// positions of the knuckles.
class FingerIkSolver {
 public:
  /// Creates a solver for a hand with at most `most_step` [rad] of change per frame.
  FingerIkSolver(RobotModel hand, double most_step);
  /// Returns the angles for points in the hand frame. A finger with an unseen point has NaN angles.
  human::HandAngles operator()(const HandKeypoints& in_hand);

 private:
  static constexpr std::size_t kJoints = 4;  ///< joints per finger
  using Angles = Eigen::Vector4d;
  /// A finger with its limits and its last solution.
  struct Finger {
    Angles lower, upper, last;
    std::array<std::size_t, kJoints> frames{};  ///< frames of its joints
    Vec3 tip_in_last = Vec3::Zero();
    bool was_seen = false;  ///< true if it was seen in the last frame
  };
  struct FingerSolve;
  void start(const HandKeypoints& in_hand, std::array<FingerSolve, kFingerCount>& tasks) const;
  void minimise(const HandKeypoints& in_hand, std::array<FingerSolve, kFingerCount>& tasks);

  RobotModel hand_;
  double max_step_rad_;
  std::array<Finger, kFingerCount> fingers_;
  std::vector<Pose> frames_;  ///< buffer
};

}  // namespace morphe::reconstruct
