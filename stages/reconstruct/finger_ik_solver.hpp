#pragma once

#include <array>
#include <vector>

#include "core/human/hand.hpp"
#include "stages/reconstruct/hand_shape.hpp"

namespace morphe::reconstruct {

/// Solves the inverse kinematics of a hand, frame after frame: the angles within its limits that
/// bring its joints and tips nearest to given points. For each finger by itself it minimises
///   sum_k |x_k(q) - p_k|² + (5 mm)² |q - q_last|²
/// over its 4 angles, with k over its two joints beyond the base and its tip. Levenberg-Marquardt
/// starts from the previous frame's angles q_last, from which no angle changes by more than
/// `max_step_rad`. The second term keeps angles constant that the points hardly determine. A finger
/// unseen in the previous frame starts half closed, without a largest change; repeated solves, each
/// with the previous one's angles as q_last, cancel the second term. The palm's arch stays flat.
class FingerIkSolver {
 public:
  /// Creates a solver for a hand with at most `max_step_rad` of change per frame.
  FingerIkSolver(RobotModel hand, double max_step_rad);
  /// Returns the angles for points in the hand frame. A finger with an unseen point has NaN angles.
  human::HandAngles operator()(const HandKeypoints& in_hand);

 private:
  static constexpr int kJoints = 4;  ///< joints per finger
  using Angles = Eigen::Vector4d;
  /// A finger with its limits and its last solution.
  struct Finger {
    Angles lower, upper, last;
    std::array<int, kJoints> frames{};  ///< frames of its joints
    Vec3 tip_in_last = Vec3::Zero();
    bool was_seen = false;  ///< in the previous frame
  };
  struct FingerSolve;
  void prepare(const HandKeypoints& in_hand, std::array<FingerSolve, kFingerCount>& tasks) const;
  void minimise(const HandKeypoints& in_hand, std::array<FingerSolve, kFingerCount>& tasks);

  RobotModel hand_;
  double max_step_rad_;
  std::array<Finger, kFingerCount> fingers_;
  std::vector<Pose> frames_;  ///< buffer
};

}  // namespace morphe::reconstruct
