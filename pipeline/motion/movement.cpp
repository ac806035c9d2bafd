#include "pipeline/motion/movement.hpp"

namespace morphe {

PhaseKind phase_at(const std::vector<Phase>& phases, double time_s) {
  const Phase* best = nullptr;
  for (const Phase& phase : phases) {
    if (time_s < phase.begin_s || time_s > phase.end_s) continue;
    const bool shorter = best && phase.end_s - phase.begin_s < best->end_s - best->begin_s;
    if (!best || shorter) best = &phase;
  }
  return best ? best->kind : PhaseKind::rest;
}

const Phase* last_phase(const Movement& movement, PhaseKind kind) {
  const Phase* found = nullptr;
  for (const Phase& phase : movement.phases) {
    if (phase.kind == kind) found = &phase;
  }
  return found;
}

}  // namespace morphe
