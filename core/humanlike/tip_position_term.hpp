#pragma once

#include "core/humanlike/term.hpp"
#include "core/motion/key_bounds.hpp"

namespace morphe::humanlike {

/// Eq. (1): sum over tips of ‖x(q) - goal‖² [m²], with x the tip or the point of it to which the
/// goal applies (robot::tracked_point).
struct TipPosition {
  static constexpr TermGroup kGroup = TermGroup::tip_position;
  double weight = 0;  ///< w_x [1/m²]
  /// Adds the term at a state, multiplied by `share`, to the loads.
  void add(const RobotState& state, const FrameGoal& goal, double share, Loads& loads) const;
};
/// Declares the config keys of the term.
template <class Fields>
void fields(Fields& f, TipPosition& o) {
  f("tip_position", o.weight, bounds::kWeight);
}

}  // namespace morphe::humanlike
