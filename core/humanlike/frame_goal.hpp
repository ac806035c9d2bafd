#pragma once

#include <array>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::humanlike {

/// What terms have in common: which of a phase's shares weighs them, and which modes leave them
/// out.
enum class Group {
  tip_position,
  tip_orientation,  ///< and the hand's
  humanlike_arm,
  humanlike_fingers,
  posture,         ///< in every mode, the same in every phase
  joint_to_joint,  ///< in that mode alone, likewise
};

/// Shares of the objective's weights in one frame, 1 unless its phase says otherwise.
struct FrameWeights {
  double tip_position = 1, tip_orientation = 1, humanlike_arm = 1, humanlike_fingers = 1;

  double of(Group group) const {
    switch (group) {
      case Group::tip_position:
        return tip_position;
      case Group::tip_orientation:
        return tip_orientation;
      case Group::humanlike_arm:
        return humanlike_arm;
      case Group::humanlike_fingers:
        return humanlike_fingers;
      case Group::posture:
      case Group::joint_to_joint:
        break;
    }
    return 1;
  }
};
template <class Fields>
void fields(Fields& f, FrameWeights& o) {
  f("tip_position", o.tip_position);
  f("tip_orientation", o.tip_orientation);
  f("humanlike_arm", o.humanlike_arm);
  f("humanlike_fingers", o.humanlike_fingers);
}

/// The goals of one frame, in the robot's base frame. NaN = no goal.
struct FrameGoal {
  std::vector<Vec3> tip_position;     ///< [m]
  std::vector<Quat> tip_orientation;  ///< [m]
  std::vector<double> pad_share;      ///< [m] as Goals::pad_share, or empty
  std::vector<Vec3> pad_normal;       ///< [m] unit, inwards, where a pad is to touch; or empty
  std::vector<std::uint8_t> closed;   ///< [m] as Goals::closed, or empty
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
  /// The human's own distances are those of the tips' goals over this.
  double hand_scale = 1;
  FrameWeights weights;

  double pad_share_of(std::size_t tip) const { return pad_share.empty() ? 0 : pad_share[tip]; }
  /// Without fingers that close by themselves: those that say where the hand is.
  int tips_recorded() const {
    int count = tips_seen();
    for (std::size_t tip = 0; tip < closed.size(); ++tip) {
      count -= closed[tip] != 0 && seen(tip_position[tip]) ? 1 : 0;
    }
    return count;
  }
  int tips_seen() const {
    int count = 0;
    for (const Vec3& tip : tip_position) count += seen(tip) ? 1 : 0;
    return count;
  }
  bool arm_seen() const { return seen(shoulder) && seen(elbow) && seen(wrist); }
};

FrameGoal frame_goal(const Goals& goals, std::size_t frame);

}  // namespace morphe::humanlike
