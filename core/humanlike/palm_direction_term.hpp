#pragma once

#include "core/humanlike/term.hpp"
#include "core/motion/key_bounds.hpp"

namespace morphe::humanlike {

/// ‖z(q) - z_h‖² + ‖y(q) - y_h‖² = 4 sin²(φ_z/2) + 4 sin²(φ_y/2), between 0 and 8. z is the
/// direction in which the palm points, y that to its thumb (RobotModel::palm_frame), z_h and y_h
/// are the human hand's, φ_z and φ_y the angles between them. Squared and bounded: it pulls in
/// proportion to the deviation while that is small, and a deviation that the goals of the tips
/// force costs little more when it grows.
struct PalmDirection {
  static constexpr TermGroup kGroup = TermGroup::tip_orientation;
  double weight = 0;
  /// Adds the term at a state, multiplied by `share`, to the loads.
  void add(const RobotState& state, const FrameGoal& goal, double share, Loads& loads) const;
};
/// Declares the config keys of the term.
template <class Fields>
void fields(Fields& f, PalmDirection& o) {
  f("palm_direction", o.weight, bounds::kWeight);
}

}  // namespace morphe::humanlike
