#pragma once

#include "core/humanlike/term.hpp"

namespace morphe::humanlike {

/// Joint-to-joint, the fingers: sum of (q_j - goal_j)² over the joints that have a goal [rad²].
/// Without a key: a mode brings it.
struct JointAngle {
  static constexpr Group kGroup = Group::joint_to_joint;
  double weight = 0;
  void add(const RobotState& state, const FrameGoal& goal, double share,
           solve::Quadratic& model) const;
};
template <class Fields>
void fields(Fields&, JointAngle&) {}

}  // namespace morphe::humanlike
