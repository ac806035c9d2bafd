#pragma once

#include <string>
#include <vector>

#include "core/humanlike/frame_goal.hpp"
#include "core/motion/movement.hpp"

namespace morphe::map {

/// The factors on the weights of `map` during a phase (config list `map.phases`). For example,
/// reaching may favour humanlikeness and grasping accuracy.
struct PhaseWeights {
  PhaseKind phase = PhaseKind::rest;  ///< the phase
  humanlike::FrameWeights factors;    ///< factors on the weights
};
template <class Fields>
void fields(Fields& f, PhaseWeights& o) {
  f.required("phase", o.phase);
  fields(f, o.factors);
}
/// Returns "" or the error: a phase named twice, or a negative weight.
std::string validation_error(const std::vector<PhaseWeights>& weights);

/// Returns the factors of the weights at a time: those of the surrounding phases, in the proportion
/// in which they fill a window of `blend_s` about it, weighted by (1 + cos) so that the factors are
/// continuous at a boundary; the phase's own with blend_s = 0. A phase that is not listed has the
/// factor 1.
humanlike::FrameWeights weights_at(const std::vector<PhaseWeights>& weights,
                                   const std::vector<Phase>& phases, double time_s, double blend_s);

}  // namespace morphe::map
