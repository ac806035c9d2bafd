#include "stages/verify/phases.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace morphe::verify {
namespace {

constexpr double kPhaseBorderTolerance_s = 1e-9;

/// Returns true if a phase may come after another in the list; preshapes are not considered.
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

bool is_phase(const Phase& phase) {
  return std::isfinite(phase.begin_s) && std::isfinite(phase.end_s) &&
         phase.begin_s <= phase.end_s && phase.confidence >= 0 && phase.confidence <= 1;
}

/// Returns true if a sample may have that phase, that is, if no phase around its time is shorter,
/// within the tolerance of the borders.
bool may_be_in(const std::vector<Phase>& phases, PhaseKind kind, double time_s) {
  double least = kInfinity;
  for (const Phase& phase : phases) {
    if (time_s >= phase.begin_s + kPhaseBorderTolerance_s &&
        time_s <= phase.end_s - kPhaseBorderTolerance_s)
      least = std::min(least, phase.end_s - phase.begin_s);
  }
  if (kind == PhaseKind::rest && least == kInfinity) return true;
  return std::ranges::any_of(phases, [&](const Phase& phase) {
    return phase.kind == kind && phase.end_s - phase.begin_s <= least &&
           time_s >= phase.begin_s - kPhaseBorderTolerance_s &&
           time_s <= phase.end_s + kPhaseBorderTolerance_s;
  });
}

void verify_phase_order(const std::vector<Phase>& phases, ViolationCollector& runs) {
  const Phase *before = nullptr, *preshape = nullptr;
  int grasps = 0;
  for (const Phase& phase : phases) {
    const auto note = [&](double value, double limit) {
      runs.note_plan("phase", std::string(name_of(phase.kind)), value, limit);
    };
    if (!is_phase(phase)) note(phase.begin_s, phase.end_s);
    if (phase.kind == PhaseKind::preshape) {
      const bool inside = before && before->kind == PhaseKind::reach && !preshape &&
                          phase.begin_s >= before->begin_s - kPhaseBorderTolerance_s &&
                          phase.end_s <= before->end_s + kPhaseBorderTolerance_s;
      if (!inside) note(phase.begin_s, before ? before->begin_s : kUnknown);
      preshape = &phase;
      continue;
    }
    grasps += phase.kind == PhaseKind::grasp ? 1 : 0;
    if (before && phase.begin_s < before->end_s - kPhaseBorderTolerance_s)
      note(phase.begin_s, before->end_s);
    const bool on_reaching =
        grasps == 0 && before && before->kind == PhaseKind::hold && phase.kind == PhaseKind::reach;
    const bool in_order = !before || on_reaching || may_follow(before->kind, phase.kind);
    if (!in_order || grasps > 1) note(phase.begin_s, kUnknown);
    before = &phase;
  }
}

}  // namespace

void verify_phases(const Plan& plan, ViolationCollector& runs) {
  const std::vector<Phase>& phases = plan.movement.phases;
  verify_phase_order(phases, runs);
  if (!phases.empty()) {
    double last_s = -kInfinity;
    for (const Phase& phase : phases) last_s = std::max(last_s, phase.end_s);
    if (!(plan.movement.begin_s >= phases.front().begin_s - kPhaseBorderTolerance_s))
      runs.note_plan("phase", "movement", plan.movement.begin_s, phases.front().begin_s);
    if (!(plan.movement.end_s <= last_s + kPhaseBorderTolerance_s))
      runs.note_plan("phase", "movement", plan.movement.end_s, last_s);
  }
  const Trajectory& trajectory = plan.trajectory;
  for (std::size_t sample = 0; sample < trajectory.samples(); ++sample) {
    const double time_s = trajectory.demonstration_time[sample];
    if (may_be_in(phases, trajectory.phase[sample], time_s)) continue;
    runs.note("phase", "trajectory",
              {static_cast<int>(2 * sample), static_cast<int>(sample), trajectory.time[sample]},
              static_cast<double>(trajectory.phase[sample]),
              static_cast<double>(phase_at(phases, time_s)), 0);
  }
}

}  // namespace morphe::verify
