#pragma once

#include "core/humanlike/term.hpp"
#include "core/motion/key_bounds.hpp"

namespace morphe::humanlike {

/// Eqs. (2), (3): sum over tips of d = acos|⟨h(q), goal⟩|, half the angle between the orientations,
/// not squared but smoothed at zero to sqrt(d² + smoothing_rad²) [rad].
struct TipOrientation {
  static constexpr TermGroup kGroup = TermGroup::tip_orientation;
  double weight = 0;  ///< w_o [1/rad]
  double smoothing_rad = 1e-3;
  /// Adds the term at a state, multiplied by `share`, to the loads.
  void add(const RobotState& state, const FrameGoal& goal, double share, Loads& loads) const;
};
/// Declares the config keys of the term.
template <class Fields>
void fields(Fields& f, TipOrientation& o) {
  f("tip_orientation", o.weight, bounds::kWeight);
}

}  // namespace morphe::humanlike
