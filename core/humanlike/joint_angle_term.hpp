#pragma once

#include "core/humanlike/term.hpp"

namespace morphe::humanlike {

/// Joint-to-joint term of the fingers: sum of (q_j - goal_j)² over the joints that have a goal
/// [rad²]. It has no key; a mode sets its weight.
struct JointAngle {
  static constexpr TermGroup kGroup = TermGroup::joint_to_joint;
  double weight = 0;
  /// Adds the term at a state, multiplied by `share`, to the model.
  void add(const RobotState& state, const FrameGoal& goal, double share,
           solve::Quadratic& model) const;
};
/// Declares no config keys.
template <class Fields>
void fields(Fields&, JointAngle&) {}

}  // namespace morphe::humanlike
