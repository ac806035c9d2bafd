#pragma once

#include "core/humanlike/term.hpp"
#include "core/motion/key_bounds.hpp"

namespace morphe::humanlike {

/// Humanlikeness C of the arm, Eqs. (7)–(9) [m³], see hull_volume_sum(). Its curvature is
/// taken as zero, except for that of the kinematics.
struct HullVolume {
  static constexpr TermGroup kGroup = TermGroup::humanlike_arm;
  double weight = 0;  ///< w_C [1/m³]
  /// Adds the term at a state, multiplied by `share`, to the loads.
  void add(const RobotState& state, const FrameGoal& goal, double share, Loads& loads) const;
};
/// Declares the config keys of the term.
template <class Fields>
void fields(Fields& f, HullVolume& o) {
  f("humanlike_hull", o.weight, bounds::kWeight);
}

}  // namespace morphe::humanlike
