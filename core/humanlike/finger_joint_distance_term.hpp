#pragma once

#include "core/humanlike/term.hpp"
#include "core/motion/key_bounds.hpp"

namespace morphe::humanlike {

/// Humanlikeness A of the fingers, second sum of Eq. (16): for each joint centre s_j of a finger,
/// ‖middle - s_j‖² divided by the number of centres of that finger [m²]. `middle` is the human's
/// middle joint of the finger whose tip the centre moves, or, for a tip between the human's fingers
/// (finger_curve_share), the point on the curve through the middle joints.
struct FingerJointDistance {
  static constexpr TermGroup kGroup = TermGroup::humanlike_fingers;
  double weight = 0;  ///< w_a [1/m²]
  /// Adds the term at a state, multiplied by `share`, to the loads.
  void add(const RobotState& state, const FrameGoal& goal, double share, Loads& loads) const;
};
/// Declares the config keys of the term.
template <class Fields>
void fields(Fields& f, FingerJointDistance& o) {
  f("humanlike_fingers", o.weight, bounds::kWeight);
}

}  // namespace morphe::humanlike
