#pragma once

#include "core/humanlike/term.hpp"

namespace morphe::humanlike {

/// The same distance as TipOrientation's for the hand: a weak goal where fewer than three tips are
/// seen.
struct HandOrientation {
  static constexpr Group kGroup = Group::tip_orientation;
  double weight = 0;  ///< [1/rad]
  double smoothing_rad = 1e-3;
  void add(const RobotState& state, const FrameGoal& goal, double share, Loads& loads) const;
};
template <class Fields>
void fields(Fields& f, HandOrientation& o) {
  f("hand_orientation", o.weight);
}

}  // namespace morphe::humanlike
