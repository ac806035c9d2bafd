#pragma once

#include "core/humanlike/term.hpp"

namespace morphe::humanlike {

/// Sum over tips with a contact of share · ‖m(q) - n‖² = share · 4 sin²(φ/2): m the middle of the
/// pad, n the inward normal of the surface it is to touch (FrameGoal::pad_normal), φ the angle
/// between them.
struct PadDirection {
  static constexpr Group kGroup = Group::tip_orientation;
  double weight = 0;
  void add(const RobotState& state, const FrameGoal& goal, double share, Loads& loads) const;
};
template <class Fields>
void fields(Fields& f, PadDirection& o) {
  f("pad_direction", o.weight);
}

}  // namespace morphe::humanlike
