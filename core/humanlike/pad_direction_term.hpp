#pragma once

#include "core/humanlike/term.hpp"
#include "core/motion/key_bounds.hpp"

namespace morphe::humanlike {

/// Sum over tips with a contact of tip_to_pad_share · ‖m(q) - n‖² = tip_to_pad_share · 4 sin²(φ/2).
/// m is the middle direction of the pad, n the inward normal of the surface that the pad should
/// touch (FrameGoal::pad_normal), and φ the angle between them.
struct PadDirection {
  static constexpr TermGroup kGroup = TermGroup::tip_orientation;
  double weight = 0;
  /// Adds the term at a state, multiplied by `share`, to the loads.
  void add(const RobotState& state, const FrameGoal& goal, double share, Loads& loads) const;
};
/// Declares the config keys of the term.
template <class Fields>
void fields(Fields& f, PadDirection& o) {
  f("pad_direction", o.weight, bounds::kWeight);
}

}  // namespace morphe::humanlike
