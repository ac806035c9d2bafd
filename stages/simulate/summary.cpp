#include "stages/simulate/summary.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "core/math/statistics.hpp"

namespace morphe::simulate {
namespace {

std::vector<double> rollout_values(const PlanResult& result,
                                   const std::function<double(const Rollout&)>& of) {
  std::vector<double> values;
  for (const Rollout& one : result.rollouts) {
    if (one.lift.failure != Failure::engine_error) values.push_back(of(one));
  }
  return values;
}

double max_or_nan(const std::vector<double>& values) {
  return values.empty() ? kUnknown : *std::ranges::max_element(values);
}

double median_of_held(const PlanResult& result, const std::function<double(const Rollout&)>& of) {
  std::vector<double> values;
  for (const Rollout& one : result.rollouts) {
    if (one.lift.is_held()) values.push_back(of(one));
  }
  return math::median(std::move(values));
}

}  // namespace

SimulationSummary summarise(const PlanResult& result) {
  SimulationSummary figures;
  figures.held = result.held_count();
  for (const Rollout& one : result.rollouts) {
    if (!one.lift.is_held()) ++figures.failures[std::string(name_of(one.lift.failure))];
    figures.correct_predictions.add(one, one.lift);
    figures.load_directions += one.load_directions.size();
    for (const HoldResult& holding : one.load_directions) {
      figures.load_directions_held += holding.is_held() ? 1U : 0U;
      if (!holding.is_held()) ++figures.direction_failures[std::string(name_of(holding.failure))];
    }
  }
  figures.droop_m =
      median_of_held(result, [](const Rollout& r) { return r.lift.droop.distance_m; });
  figures.slip_m = median_of_held(result, [](const Rollout& r) { return r.lift.slip_m; });
  figures.drift_m =
      median_of_held(result, [](const Rollout& r) { return r.lift.drift.distance_m; });
  figures.arm_error =
      max_or_nan(rollout_values(result, [](const Rollout& r) { return r.arm_error; }));
  figures.hand_error =
      max_or_nan(rollout_values(result, [](const Rollout& r) { return r.hand_error; }));
  figures.torque_ratio =
      max_or_nan(rollout_values(result, [](const Rollout& r) { return r.torque_ratio; }));
  figures.required_force_N = math::median(
      rollout_values(result, [](const Rollout& r) { return r.lift.required_force_N; }));
  figures.commanded_force_N =
      math::median(rollout_values(result, [](const Rollout& r) { return r.commanded_force_N; }));
  std::vector<double> late;
  for (const Rollout& one : result.rollouts) {
    if (std::isfinite(one.contact_s)) late.push_back(one.contact_s - result.planned_contact_s);
  }
  figures.contact_delay_s = math::median(std::move(late));
  return figures;
}

}  // namespace morphe::simulate
