#pragma once

#include "core/humanlike/term.hpp"

namespace morphe::humanlike {

/// Joint-to-joint, the arm: sum over the joints of arm_chain() beyond the shoulder of
/// ‖s_j - goal_j‖² [m²]. No term of the paper's objective, and without a key: a mode brings it.
struct ChainPosition {
  static constexpr Group kGroup = Group::joint_to_joint;
  double weight = 0;
  void add(const RobotState& state, const FrameGoal& goal, double share, Loads& loads) const;
};
template <class Fields>
void fields(Fields&, ChainPosition&) {}

}  // namespace morphe::humanlike
