#pragma once

#include "core/humanlike/term.hpp"

namespace morphe::humanlike {

/// Eqs. (2), (3): acos|⟨h, g⟩| of the tips' orientations, half the rotation angle, not squared;
/// smoothed at zero to sqrt(d² + smoothing²).
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
  f("tip_orientation", o.weight);
}

}  // namespace morphe::humanlike
