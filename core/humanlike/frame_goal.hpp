#pragma once

#include <array>
#include <concepts>
#include <type_traits>
#include <vector>

#include "core/motion/key_bounds.hpp"
#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::humanlike {

/// The group of a term. It determines the factor of the term's weight in each phase, and the modes
/// in which the term is omitted.
enum class TermGroup {
  tip_position,
  tip_orientation,  ///< also directions of pads, orientation of the hand
  humanlike_arm,
  humanlike_fingers,
  posture,         ///< used in every mode, with the same weight in every phase
  joint_to_joint,  ///< used in joint-to-joint mode only, with the same weight in every phase
};

/// The factors of the terms' weights in one frame. A config may set them for each phase.
struct FrameWeights {
  double tip_position = 1, tip_orientation = 1, humanlike_arm = 1, humanlike_fingers = 1;

  /// Returns the factor of a group of terms.
  double of(TermGroup group) const {
    switch (group) {
      case TermGroup::tip_position:
        return tip_position;
      case TermGroup::tip_orientation:
        return tip_orientation;
      case TermGroup::humanlike_arm:
        return humanlike_arm;
      case TermGroup::humanlike_fingers:
        return humanlike_fingers;
      case TermGroup::posture:
      case TermGroup::joint_to_joint:
        break;
    }
    return 1;
  }
};
/// Declares the config keys of the factors.
template <class Fields>
void fields(Fields& f, FrameWeights& o) {
  f("tip_position", o.tip_position, bounds::kWeight);
  f("tip_orientation", o.tip_orientation, bounds::kWeight);
  f("humanlike_arm", o.humanlike_arm, bounds::kWeight);
  f("humanlike_fingers", o.humanlike_fingers, bounds::kWeight);
}

/// The goals of one frame, in the robot's base frame; NaN if there is no goal. [m] stands for one
/// entry per tip.
struct FrameGoal {
  std::vector<Vec3> tip_position;              ///< [m]
  std::vector<Quat> tip_orientation;           ///< [m]
  std::vector<double> tip_to_pad_share;        ///< [m] as Goals::tip_to_pad_share, or empty
  std::vector<Vec3> pad_normal;                ///< [m] unit, into the object; or empty
  std::vector<std::uint8_t> closes_by_itself;  ///< [m] as Goals::auto_closed, or empty
  Quat hand = unknown_rotation();              ///< base_from_hand
  /// Positions of the human arm, shifted to the common base (Goals).
  Vec3 shoulder = unknown_point(), elbow = unknown_point(), wrist = unknown_point();
  /// Positions of the human's middle joints.
  std::array<Vec3, kFingerCount> finger_joint{unknown_point(), unknown_point(), unknown_point(),
                                              unknown_point(), unknown_point()};
  /// For tips between the human's fingers: the point at RobotModel::Tip::finger_curve_share of the
  /// curve through the middle joints. Empty if the hand has no such tips.
  std::vector<Vec3> interpolated_finger_joint;  ///< [m]
  std::vector<Vec3> chain;  ///< goals of the joint-to-joint mode for arm_chain(), or empty
  JointVector angles;       ///< goals of the joint-to-joint mode, NaN = no goal; or empty
  double hand_scale = 1;    ///< by which the human's tip goals were scaled for the robot's hand
  FrameWeights weights;

  /// Returns tip_to_pad_share of a tip, or 0 if it is empty.
  double tip_to_pad_share_of(std::ptrdiff_t tip) const {
    return tip_to_pad_share.empty() ? 0 : tip_to_pad_share[tip];
  }
  /// Returns the number of tips with a position goal from the recording: without closes_by_itself.
  int recorded_tip_count() const {
    int count = goal_tip_count();
    for (int tip = 0; tip < std::ssize(closes_by_itself); ++tip) {
      if (closes_by_itself[tip] != 0 && is_known(tip_position[tip])) --count;
    }
    return count;
  }
  /// Returns the number of tips with a position goal.
  int goal_tip_count() const {
    int count = 0;
    for (const Vec3& position : tip_position) {
      if (is_known(position)) ++count;
    }
    return count;
  }
  /// Returns true if shoulder, elbow and wrist of the human are known.
  bool has_arm_goal() const { return is_known(shoulder) && is_known(elbow) && is_known(wrist); }
};

/// Calls f for each measured quantity of a goal, which may be const: f(Vec3&) for points [m] and
/// unit normals, f(Quat&) for rotations, f(double&) for shares and angles [rad]. Not visited are
/// closes_by_itself, hand_scale and weights. A new member of FrameGoal must be named here, whether
/// it is visited or not; otherwise this does not compile.
template <class Goal, class F>
requires std::same_as<std::remove_const_t<Goal>, FrameGoal>
void for_each_quantity(Goal& goal, const F& f) {
  auto& [tip_position, tip_orientation, tip_to_pad_share, pad_normal, closes_by_itself, hand,
         shoulder, elbow, wrist, finger_joint, interpolated_finger_joint, chain, angles, hand_scale,
         weights] = goal;
  const auto each = [&f](auto& values) {
    for (auto& value : values) f(value);
  };
  each(tip_position);
  each(tip_orientation);
  each(tip_to_pad_share);
  each(pad_normal);
  f(hand);
  f(shoulder);
  f(elbow);
  f(wrist);
  each(finger_joint);
  each(interpolated_finger_joint);
  each(chain);
  each(angles);
}

/// Returns the goal of a frame. Pad normals, interpolated finger joints, chain and angles are
/// empty, weights 1.
FrameGoal frame_goal(const Goals& goals, std::size_t frame);

}  // namespace morphe::humanlike
