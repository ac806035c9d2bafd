#pragma once

#include <array>
#include <vector>

#include "pipeline/motion/plan.hpp"
#include "pipeline/motion/robot_table.hpp"

namespace morphe {

/// The goals of one frame, in the robot's base frame. NaN = no goal.
struct FrameGoal {
  std::vector<Vec3> tip_position;           ///< [m]
  std::vector<Quat> tip_orientation;        ///< [m]
  Quat hand = unseen_rotation();            ///< base_from_hand
  Vec3 elbow = unseen_point();              ///< human elbow in the common base frame
  std::array<Vec3, kFingers> finger_joint;  ///< middle joints of the human's fingers

  int tips_seen() const {
    int count = 0;
    for (const Vec3& tip : tip_position) count += seen(tip) ? 1 : 0;
    return count;
  }
};

FrameGoal frame_goal(const Goals& goals, std::size_t frame);

}  // namespace morphe
