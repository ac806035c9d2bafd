#pragma once

#include "core/humanlike/term.hpp"
#include "core/motion/key_bounds.hpp"

namespace morphe::humanlike {

/// The distance of TipOrientation, for the palm's orientation: a goal of the hand in frames in
/// which fewer than three tips have a recorded goal.
struct HandOrientation {
  static constexpr TermGroup kGroup = TermGroup::tip_orientation;
  double weight = 0;  ///< [1/rad]
  double smoothing_rad = 1e-3;
  /// Adds the term at a state, multiplied by `share`, to the loads.
  void add(const RobotState& state, const FrameGoal& goal, double share, Loads& loads) const;
};
/// Declares the config keys of the term.
template <class Fields>
void fields(Fields& f, HandOrientation& o) {
  f("hand_orientation", o.weight, bounds::kWeight);
}

}  // namespace morphe::humanlike
