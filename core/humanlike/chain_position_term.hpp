#pragma once

#include "core/humanlike/term.hpp"

namespace morphe::humanlike {

/// Joint-to-joint term of the arm: sum of ‖s_j - goal_j‖² over the joints s_j of arm_chain() beyond
/// the shoulder [m²]. It is not in the paper's objective and has no key; a mode sets its weight.
struct ChainPosition {
  static constexpr TermGroup kGroup = TermGroup::joint_to_joint;
  double weight = 0;
  /// Adds the term at a state, multiplied by `share`, to the loads.
  void add(const RobotState& state, const FrameGoal& goal, double share, Loads& loads) const;
};
/// Declares no config keys.
template <class Fields>
void fields(Fields&, ChainPosition&) {}

}  // namespace morphe::humanlike
