#pragma once

#include <string>
#include <vector>

#include "core/humanlike/frame_goal.hpp"
#include "core/motion/movement.hpp"

namespace morphe::map {

/// The factors on the weights of `map` during a phase (config list `map.phases`). For example,
/// reaching may favour humanlikeness and grasping accuracy.
struct PhaseWeights {
  PhaseKind phase = PhaseKind::rest;
  humanlike::FrameWeights factors;
};
template <class Fields>
void fields(Fields& f, PhaseWeights& o) {
  f.required("phase", o.phase);
  fields(f, o.factors);
}
/// Returns "" or the error: a phase named twice, or a negative weight.
std::string validation_error(const std::vector<PhaseWeights>& weights);

/// Returns the factors at a time. A lift, place, release, retreat or home that is not listed has
/// those of the main phase at that time; those of other phases that are not listed are 1. They are
/// the mean over a window of the length `blend_s` about the time, weighted by 1 + cos, which is
/// continuous from phase to phase. If blend_s <= 0, they are the factors of the phase itself.
humanlike::FrameWeights weights_at(const std::vector<PhaseWeights>& weights,
                                   const std::vector<Phase>& phases, double time_s, double blend_s);

}  // namespace morphe::map
