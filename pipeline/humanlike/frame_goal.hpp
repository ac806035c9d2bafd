#pragma once

#include <array>
#include <vector>

#include "pipeline/motion/plan.hpp"
#include "pipeline/motion/robot_table.hpp"

namespace morphe::humanlike {

/// Shares of the objective's weights in one frame, 1 unless its phase says otherwise.
struct FrameWeights {
  double tip_position = 1, tip_orientation = 1, humanlike_arm = 1, humanlike_fingers = 1;
};

/// The goals of one frame, in the robot's base frame. NaN = no goal.
struct FrameGoal {
  std::vector<Vec3> tip_position;     ///< [m]
  std::vector<Quat> tip_orientation;  ///< [m]
  Quat hand = unseen_rotation();      ///< base_from_hand
  /// Human arm in the common base frame.
  Vec3 shoulder = unseen_point(), elbow = unseen_point(), wrist = unseen_point();
  /// Middle joints of the human's fingers.
  std::array<Vec3, kFingers> finger_joint{unseen_point(), unseen_point(), unseen_point(),
                                          unseen_point(), unseen_point()};
  /// Of a tip that follows no finger of its own (RobotTable::Tip::along): the same share of the
  /// curve through the middle joints. Empty: none.
  std::vector<Vec3> curve_joint;  ///< [m]
  /// What joint-to-joint asks for: where each joint of arm_chain() belongs, and angles (NaN =
  /// none). Empty in every other mode.
  std::vector<Vec3> chain;
  JointVector angles;
  FrameWeights weights;

  int tips_seen() const {
    int count = 0;
    for (const Vec3& tip : tip_position) count += seen(tip) ? 1 : 0;
    return count;
  }
};

FrameGoal frame_goal(const Goals& goals, std::size_t frame);

}  // namespace morphe::humanlike
