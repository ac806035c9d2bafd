#pragma once

#include "core/humanlike/term.hpp"

namespace morphe::humanlike {

/// Humanlikeness A of the arm, Eq. (5): sum_j ‖s_elbow - s_j‖² over the k joint centres, divided by
/// k so that the weight means the same for every robot [m²].
struct JointDistance {
  static constexpr Group kGroup = Group::humanlike_arm;
  double weight = 0;  ///< w_A, on the mean over the joint centres [1/m²]
  void add(const RobotState& state, const FrameGoal& goal, double share, Loads& loads) const;
};
template <class Fields>
void fields(Fields& f, JointDistance& o) {
  f("humanlike_arm", o.weight);
}

}  // namespace morphe::humanlike
