#pragma once

#include "core/humanlike/term.hpp"
#include "core/motion/key_bounds.hpp"

namespace morphe::humanlike {

/// Humanlikeness A of the arm, Eq. (5): sum of ‖elbow - s_j‖² over the arm's joint centres s_j,
/// divided by their number so that the weight has the same meaning for every robot [m²].
struct JointDistance {
  static constexpr TermGroup kGroup = TermGroup::humanlike_arm;
  double weight = 0;  ///< w_A, for the mean over the joint centres [1/m²]
  /// Adds the term at a state, multiplied by `share`, to the loads.
  void add(const RobotState& state, const FrameGoal& goal, double share, Loads& loads) const;
};
/// Declares the config keys of the term.
template <class Fields>
void fields(Fields& f, JointDistance& o) {
  f("humanlike_arm", o.weight, bounds::kWeight);
}

}  // namespace morphe::humanlike
