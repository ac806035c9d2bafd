#include "core/motion/movement.hpp"

#include <algorithm>

namespace morphe {

PhaseKind phase_at(const std::vector<Phase>& phases, double time_s) {
  const Phase* shortest = nullptr;
  for (const Phase& phase : phases) {
    if (time_s < phase.begin_s || time_s > phase.end_s) continue;
    if (!shortest || phase.end_s - phase.begin_s < shortest->end_s - shortest->begin_s)
      shortest = &phase;
  }
  return shortest ? shortest->kind : PhaseKind::rest;
}

bool is_grasping_at(const Movement& movement, double time_s) {
  return std::ranges::any_of(movement.phases, [&](const Phase& phase) {
    const bool grasps = phase.kind == PhaseKind::grasp || phase.kind == PhaseKind::hold;
    return grasps && time_s >= phase.begin_s && time_s <= phase.end_s;
  });
}

const Phase* last_phase(const Movement& movement, PhaseKind kind) {
  const Phase* found = nullptr;
  for (const Phase& phase : movement.phases)
    if (phase.kind == kind) found = &phase;
  return found;
}

}  // namespace morphe
