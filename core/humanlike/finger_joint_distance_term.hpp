#pragma once

#include "core/humanlike/term.hpp"

namespace morphe::humanlike {

/// Humanlikeness A of the fingers, second sum of Eq. (16): ‖s_middle - s_j‖² for each finger whose
/// human middle joint was seen, divided by the number of centres of that finger [m²]. A centre's
/// finger is that of the tip which it moves; a tip between the human's fingers (`along`) has the
/// point of the curve through their middle joints.
struct FingerJointDistance {
  static constexpr Group kGroup = Group::humanlike_fingers;
  double weight = 0;  ///< w_a [1/m²]
  void add(const RobotState& state, const FrameGoal& goal, double share, Loads& loads) const;
};
template <class Fields>
void fields(Fields& f, FingerJointDistance& o) {
  f("humanlike_fingers", o.weight);
}

}  // namespace morphe::humanlike
