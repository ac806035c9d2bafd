#pragma once

#include "core/humanlike/term.hpp"
#include "core/motion/key_bounds.hpp"

namespace morphe::humanlike {

/// Humanlikeness B of the arm, Eq. (6) [m²], see triangle_area_gradient().
struct TriangleArea {
  static constexpr TermGroup kGroup = TermGroup::humanlike_arm;
  double weight = 0;  ///< w_B [1/m²]
  double smoothing_m2 = 1e-6;
  /// Adds the term at a state, multiplied by `share`, to the loads.
  void add(const RobotState& state, const FrameGoal& goal, double share, Loads& loads) const;
};
/// Declares the config keys of the term.
template <class Fields>
void fields(Fields& f, TriangleArea& o) {
  f("humanlike_triangle", o.weight, bounds::kWeight);
}

}  // namespace morphe::humanlike
