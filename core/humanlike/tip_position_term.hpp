#pragma once

#include "core/humanlike/term.hpp"

namespace morphe::humanlike {

/// Eq. (1): sum over tips of ‖x(q) - x_goal‖² [m²]; x the tip, or the pad that is to touch
/// (robot::goal_point).
struct TipPosition {
  static constexpr Group kGroup = Group::tip_position;
  double weight = 0;  ///< w_x [1/m²]
  void add(const RobotState& state, const FrameGoal& goal, double share, Loads& loads) const;
};
template <class Fields>
void fields(Fields& f, TipPosition& o) {
  f("tip_position", o.weight);
}

}  // namespace morphe::humanlike
