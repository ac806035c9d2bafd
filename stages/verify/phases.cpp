#include "stages/verify/phases.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace morphe::verify {
namespace {

constexpr double kPhaseBorderTolerance_s = 1e-9;

/// Returns true if a phase may come next after another in the list; neither is a preshape.
bool may_follow(PhaseKind before, PhaseKind after) {
  const auto stage = [](PhaseKind kind) {
    switch (kind) {
      case PhaseKind::rest:
        return 0;
      case PhaseKind::reach:
      case PhaseKind::preshape:
        return 1;
      case PhaseKind::grasp:
        return 2;
      case PhaseKind::hold:
      case PhaseKind::transport:
        return 3;
      default:
        return 4;
    }
  };
  return stage(before) <= stage(after) &&
         !(before == PhaseKind::grasp && after == PhaseKind::grasp);
}

bool is_valid_phase(const Phase& phase) {
  return std::isfinite(phase.begin_s) && std::isfinite(phase.end_s) &&
         phase.begin_s <= phase.end_s && phase.confidence >= 0 && phase.confidence <= 1;
}

/// Returns true for the kinds that refine transport and return.
bool is_refining(PhaseKind kind) {
  return kind == PhaseKind::lift || kind == PhaseKind::place || kind == PhaseKind::release ||
         kind == PhaseKind::retreat || kind == PhaseKind::home;
}

bool is_inside(const Phase& phase, double time_s) {
  return time_s >= phase.begin_s + kPhaseBorderTolerance_s &&
         time_s <= phase.end_s - kPhaseBorderTolerance_s;
}

/// Returns true if a sample at this time may be in a phase of this kind: there is one at the time,
/// and no phase around the time is shorter; or it is rest, and no phase is around the time. Phases
/// that refine others are compared with each other, and count as shorter than the others.
bool may_be_in(const std::vector<Phase>& phases, PhaseKind kind, double time_s) {
  const bool refining = is_refining(kind);
  double shortest_s = kInfinity;
  for (const Phase& phase : phases) {
    if (!is_inside(phase, time_s)) continue;
    if (is_refining(phase.kind) && !refining) return false;
    if (is_refining(phase.kind) == refining)
      shortest_s = std::min(shortest_s, phase.end_s - phase.begin_s);
  }
  if (kind == PhaseKind::rest && shortest_s == kInfinity) return true;
  return std::ranges::any_of(phases, [&](const Phase& phase) {
    return phase.kind == kind && phase.end_s - phase.begin_s <= shortest_s &&
           time_s >= phase.begin_s - kPhaseBorderTolerance_s &&
           time_s <= phase.end_s + kPhaseBorderTolerance_s;
  });
}

void verify_phase_order(const std::vector<Phase>& phases, ViolationLog& violations) {
  const Phase *previous = nullptr, *preshape = nullptr;
  int grasps = 0;
  for (const Phase& phase : phases) {
    if (is_refining(phase.kind)) continue;
    const auto note = [&](double value, double limit) {
      violations.note_plan("phase", std::string(name_of(phase.kind)), value, limit);
    };
    if (!is_valid_phase(phase)) note(phase.begin_s, phase.end_s);
    if (phase.kind == PhaseKind::approach) note(phase.begin_s, kUnknown);
    if (phase.kind == PhaseKind::preshape) {
      const bool inside = previous && previous->kind == PhaseKind::reach && !preshape &&
                          phase.begin_s >= previous->begin_s - kPhaseBorderTolerance_s &&
                          phase.end_s <= previous->end_s + kPhaseBorderTolerance_s;
      if (!inside) note(phase.begin_s, previous ? previous->begin_s : kUnknown);
      preshape = &phase;
      continue;
    }
    grasps += phase.kind == PhaseKind::grasp ? 1 : 0;
    if (previous && phase.begin_s < previous->end_s - kPhaseBorderTolerance_s)
      note(phase.begin_s, previous->end_s);
    const bool reaching_again = grasps == 0 && previous && previous->kind == PhaseKind::hold &&
                                phase.kind == PhaseKind::reach;
    const bool in_order = !previous || reaching_again || may_follow(previous->kind, phase.kind);
    if (!in_order || grasps > 1) note(phase.begin_s, kUnknown);
    previous = &phase;
  }
}

/// Returns the first or last phase of a kind, null if there is none.
const Phase* phase_of(const std::vector<Phase>& phases, PhaseKind kind, bool last) {
  const Phase* found = nullptr;
  for (const Phase& phase : phases)
    if (phase.kind == kind && (last || !found)) found = &phase;
  return found;
}

/// Notes phases that refine transport and return and are outside of the interval that they divide.
void verify_refining_phases(const std::vector<Phase>& phases, ViolationLog& violations) {
  const Phase* first = phase_of(phases, PhaseKind::transport, false);
  const Phase* carried = phase_of(phases, PhaseKind::transport, true);
  const Phase* back = phase_of(phases, PhaseKind::return_phase, true);
  const auto near = [](double a, double b) { return std::abs(a - b) <= kPhaseBorderTolerance_s; };
  const Phase* previous = nullptr;
  for (const Phase& phase : phases) {
    if (!is_refining(phase.kind)) continue;
    bool inside = is_valid_phase(phase) && carried && (!previous || previous->kind < phase.kind) &&
                  (!previous || phase.begin_s >= previous->end_s - kPhaseBorderTolerance_s ||
                   phase.kind == PhaseKind::place);
    if (inside && phase.kind == PhaseKind::lift) {
      inside = near(phase.begin_s, first->begin_s) &&
               phase.end_s <= first->end_s + kPhaseBorderTolerance_s;
    } else if (inside) {
      const bool place = phase.kind == PhaseKind::place;
      inside = back && (place ? near(phase.end_s, carried->end_s) &&
                                    phase.begin_s >= carried->begin_s - kPhaseBorderTolerance_s
                              : phase.begin_s >= carried->end_s - kPhaseBorderTolerance_s &&
                                    phase.end_s <= back->end_s + kPhaseBorderTolerance_s);
    }
    if (!inside)
      violations.note_plan("phase", std::string(name_of(phase.kind)), phase.begin_s, phase.end_s);
    previous = &phase;
  }
}

}  // namespace

void verify_phases(const Plan& plan, ViolationLog& violations) {
  const std::vector<Phase>& phases = plan.movement.phases;
  verify_phase_order(phases, violations);
  verify_refining_phases(phases, violations);
  if (!phases.empty()) {
    double last_s = -kInfinity;
    for (const Phase& phase : phases) last_s = std::max(last_s, phase.end_s);
    if (!(plan.movement.begin_s >= phases.front().begin_s - kPhaseBorderTolerance_s))
      violations.note_plan("phase", "movement", plan.movement.begin_s, phases.front().begin_s);
    if (!(plan.movement.end_s <= last_s + kPhaseBorderTolerance_s))
      violations.note_plan("phase", "movement", plan.movement.end_s, last_s);
  }
  const Trajectory& trajectory = plan.trajectory;
  for (int sample = 0; sample < std::ssize(trajectory.time); ++sample) {
    const double time_s = trajectory.demonstration_time[sample];
    if (may_be_in(phases, trajectory.phase[sample], time_s)) continue;
    violations.note("phase", "trajectory", point_at_sample(trajectory, sample),
                    static_cast<double>(trajectory.phase[sample]),
                    static_cast<double>(phase_at(phases, time_s)), 0);
  }
}

}  // namespace morphe::verify
