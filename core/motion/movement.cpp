#include "core/motion/movement.hpp"

#include <algorithm>
#include <cmath>

namespace morphe {

namespace {

bool is_main(const Phase& phase) { return main_phase_of(phase.kind) == phase.kind; }

/// Returns the shortest phase that contains a time, of the main phases or of those refining them.
const Phase* shortest_at(const std::vector<Phase>& phases, double time_s, bool main) {
  const Phase* shortest = nullptr;
  for (const Phase& phase : phases) {
    if (is_main(phase) != main || time_s < phase.begin_s || time_s > phase.end_s) continue;
    if (!shortest || phase.end_s - phase.begin_s < shortest->end_s - shortest->begin_s)
      shortest = &phase;
  }
  return shortest;
}

}  // namespace

PhaseKind phase_at(const std::vector<Phase>& phases, double time_s) {
  const Phase* refining = shortest_at(phases, time_s, false);
  return refining ? refining->kind : main_phase_at(phases, time_s);
}

PhaseKind main_phase_at(const std::vector<Phase>& phases, double time_s) {
  const Phase* main = shortest_at(phases, time_s, true);
  return main ? main->kind : PhaseKind::rest;
}

bool is_grasping_at(const Movement& movement, double time_s) {
  const Phase* transport = last_phase(movement, PhaseKind::transport);
  return std::ranges::any_of(movement.phases, [&](const Phase& phase) {
    const bool holds =
        phase.kind == PhaseKind::hold && !(transport && phase.begin_s >= transport->end_s);
    return (phase.kind == PhaseKind::grasp || holds) && time_s >= phase.begin_s &&
           time_s <= phase.end_s;
  });
}

double carrying_begin_s(const Movement& movement) {
  if (movement.target.empty()) return kUnknown;
  for (const Phase& phase : movement.phases) {
    if (phase.kind == PhaseKind::transport && phase.begin_s < movement.end_s) return phase.begin_s;
  }
  return kUnknown;
}

HeldInterval held_interval(const Movement& movement) {
  const Phase* grasp = last_phase(movement, PhaseKind::grasp);
  if (!grasp || std::isnan(carrying_begin_s(movement))) return {};
  return {grasp->begin_s - kSettling_s,
          last_phase(movement, PhaseKind::transport)->end_s + kSettling_s};
}

const Phase* last_phase(const Movement& movement, PhaseKind kind) {
  const Phase* found = nullptr;
  for (const Phase& phase : movement.phases)
    if (phase.kind == kind) found = &phase;
  return found;
}

const Phase* planned_end(const Movement& movement, PhaseKind kind) {
  for (const PhaseKind own : {kind, main_phase_of(kind), PhaseKind::grasp})
    if (const Phase* phase = last_phase(movement, own)) return phase;
  return nullptr;
}

bool is_put_down(const Movement& movement) {
  const Phase* transport = last_phase(movement, PhaseKind::transport);
  const Phase* back = last_phase(movement, PhaseKind::return_phase);
  return transport && back && back->begin_s >= transport->end_s;
}

}  // namespace morphe
