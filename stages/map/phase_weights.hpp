#pragma once

#include <string>
#include <vector>

#include "core/humanlike/frame_goal.hpp"
#include "core/motion/movement.hpp"

namespace morphe::map {

/// Config list `map.phases`: what a phase multiplies the weights of `map` by. Reaching may favour
/// humanlikeness, grasping accuracy.
struct PhaseWeights {
  PhaseKind phase = PhaseKind::rest;
  humanlike::FrameWeights shares;
};
template <class Fields>
void fields(Fields& f, PhaseWeights& o) {
  f.required("phase", o.phase);
  fields(f, o.shares);
}
/// Empty, or what is wrong: a phase named twice, a negative weight.
std::string why_invalid(const std::vector<PhaseWeights>& weights);

/// The weights' shares at a time: those of the phases around it in the proportion in which they
/// fill a window of `blend_s` about it, weighed by (1 + cos) so that nothing jumps at a boundary;
/// the phase's own with blend_s = 0. A phase that is not listed has 1.
humanlike::FrameWeights weights_at(const std::vector<PhaseWeights>& weights,
                                   const std::vector<Phase>& phases, double time_s, double blend_s);

}  // namespace morphe::map
