#pragma once

#include <string>
#include <vector>

#include "pipeline/humanlike/frame_goal.hpp"
#include "pipeline/motion/movement.hpp"

namespace morphe::map {

/// Config list `map.phases`: what a phase multiplies the weights of `map` by. Reaching may favour
/// humanlikeness, grasping accuracy.
struct PhaseWeights {
  PhaseKind phase = PhaseKind::rest;
  double tip_position = 1, tip_orientation = 1, humanlike_arm = 1, humanlike_fingers = 1;
};
template <class Fields>
void fields(Fields& f, PhaseWeights& o) {
  f.required("phase", o.phase);
  f("tip_position", o.tip_position);
  f("tip_orientation", o.tip_orientation);
  f("humanlike_arm", o.humanlike_arm);
  f("humanlike_fingers", o.humanlike_fingers);
}
/// Empty, or what is wrong: a phase named twice, a negative weight.
std::string why_invalid(const std::vector<PhaseWeights>& weights);

/// The weights' shares at a time: those of the phases around it in the proportion in which they
/// fill a window of `blend_s` about it, weighed by (1 + cos) so that nothing jumps at a boundary;
/// the phase's own with blend_s = 0. A phase that is not listed has 1.
humanlike::FrameWeights weights_at(const std::vector<PhaseWeights>& weights,
                                   const std::vector<Phase>& phases, double time_s, double blend_s);

}  // namespace morphe::map
