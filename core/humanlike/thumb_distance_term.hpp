#pragma once

#include "core/humanlike/term.hpp"
#include "core/motion/key_bounds.hpp"

namespace morphe::humanlike {

/// Keeps pinches closed for hands of different size: over the fingers other than the thumb,
///   sum of s(d) (‖x_thumb(q) - x(q)‖ - d)² [m²],  d = ‖goal_thumb - goal‖ / hand_scale.
/// d is the distance of the human's own tips. s is a proximity weight: 1 up to full_distance_m, 0
/// from zero_distance_m on, and between them a cubic with zero slope at both ends. The direction
/// from tip to tip is left to their position goals, because few robot thumbs oppose a finger as the
/// human's does.
struct ThumbDistance {
  static constexpr TermGroup kGroup = TermGroup::tip_position;
  double weight = 0;  ///< [1/m²]
  double full_distance_m = 0.04, zero_distance_m = 0.06;
  /// Adds the term at a state, multiplied by `share`, to the model.
  void add(const RobotState& state, const FrameGoal& goal, double share,
           solve::Quadratic& model) const;
  /// Returns the proximity weight s of a distance.
  double proximity_weight(double distance_m) const;
};
/// Declares the config keys of the term.
template <class Fields>
void fields(Fields& f, ThumbDistance& o) {
  f("thumb_distance", o.weight, bounds::kWeight);
  f("thumb_full_distance", o.full_distance_m, bounds::kLength);
  f("thumb_zero_distance", o.zero_distance_m, bounds::kLength);
}

}  // namespace morphe::humanlike
