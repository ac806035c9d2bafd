#pragma once

#include "core/humanlike/term.hpp"

namespace morphe::humanlike {

/// Humanlikeness A of the fingers, second sum of Eq. (16): ‖s_middle - s_j‖² for each finger whose
/// human middle joint was observed, divided by the number of centres of that finger [m²]. A centre
/// belongs to the finger of the tip that it moves; for a tip between the human's fingers (`along`),
/// s_middle is the point on the curve through their middle joints.
struct FingerJointDistance {
  static constexpr TermGroup kGroup = TermGroup::humanlike_fingers;
  double weight = 0;  ///< w_a [1/m²]
  /// Adds the term at a state, multiplied by `share`, to the loads.
  void add(const RobotState& state, const FrameGoal& goal, double share, Loads& loads) const;
};
/// Declares the config keys of the term.
template <class Fields>
void fields(Fields& f, FingerJointDistance& o) {
  f("humanlike_fingers", o.weight);
}

}  // namespace morphe::humanlike
