#pragma once

#include "core/humanlike/term.hpp"

namespace morphe::humanlike {

/// Humanlikeness B of the arm, Eq. (6) [m²], see triangle_area_sum; rounded off where a triangle
/// vanishes.
struct TriangleArea {
  static constexpr Group kGroup = Group::humanlike_arm;
  double weight = 0;  ///< w_B [1/m²]
  double smoothing_m2 = 1e-6;
  void add(const RobotState& state, const FrameGoal& goal, double share, Loads& loads) const;
};
template <class Fields>
void fields(Fields& f, TriangleArea& o) {
  f("humanlike_triangle", o.weight);
}

}  // namespace morphe::humanlike
