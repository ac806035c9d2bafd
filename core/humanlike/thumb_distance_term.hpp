#pragma once

#include "core/humanlike/term.hpp"

namespace morphe::humanlike {

/// Pinches close whatever the hands' sizes: over the fingers other than the thumb,
///   sum of s(d) (‖x_thumb(q) - x(q)‖ - d)² [m²],  d = ‖goal_thumb - goal‖ / hand_scale,
/// d the distance of the human's own tips and s how near they are: 1 up to near_m, nothing from
/// far_m on, between them the cubic with no slope at either end. Which way the tips lie from each
/// other is left to their goals: few robots' thumbs oppose a finger as the human's does.
struct ThumbDistance {
  static constexpr Group kGroup = Group::tip_position;
  double weight = 0;  ///< [1/m²]
  double near_m = 0.04, far_m = 0.06;
  void add(const RobotState& state, const FrameGoal& goal, double share,
           solve::Quadratic& model) const;
  /// s(d)
  double nearness(double distance_m) const;
};
template <class Fields>
void fields(Fields& f, ThumbDistance& o) {
  f("thumb_distance", o.weight);
  f("thumb_near", o.near_m);
  f("thumb_far", o.far_m);
}

}  // namespace morphe::humanlike
