#pragma once

#include "core/humanlike/term.hpp"

namespace morphe::humanlike {

/// Humanlikeness C of the arm, Eqs. (7)–(9) [m³], see hull_volume_sum: without a curvature of its
/// own.
struct HullVolume {
  static constexpr Group kGroup = Group::humanlike_arm;
  double weight = 0;  ///< w_C [1/m³]
  void add(const RobotState& state, const FrameGoal& goal, double share, Loads& loads) const;
};
template <class Fields>
void fields(Fields& f, HullVolume& o) {
  f("humanlike_hull", o.weight);
}

}  // namespace morphe::humanlike
