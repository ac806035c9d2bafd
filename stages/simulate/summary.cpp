#include "stages/simulate/summary.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/math/statistics.hpp"

namespace morphe::simulate {
namespace {

using Quantity = double (*)(const Rollout&);

/// Returns the failure of the task, if there is one, else that of the lift.
Failure failure_of(const Rollout& one) { return one.task ? one.task->failure : one.lift.failure; }

std::vector<double> values_of(const PlanResult& result, bool only_held, Quantity quantity) {
  std::vector<double> values;
  for (const Rollout& one : result.rollouts)
    if (only_held ? one.lift.is_held() : one.lift.failure != Failure::engine_error)
      values.push_back(quantity(one));
  return values;
}

/// Returns the median of a quantity of the tasks in which the target was held until the release.
double task_median(const PlanResult& result, double (*quantity)(const TaskResult&)) {
  std::vector<double> values;
  for (const Rollout& one : result.rollouts)
    if (one.task && one.lift.is_held()) values.push_back(quantity(*one.task));
  return math::median(std::move(values));
}

}  // namespace

SimulationSummary summarise(const PlanResult& result) {
  SimulationSummary figures;
  figures.held = result.held_count();
  for (const Rollout& one : result.rollouts) {
    const Failure failure = failure_of(one);
    if (failure != Failure::none) ++figures.failures[std::string(name_of(failure))];
    figures.tasks += one.task ? 1U : 0U;
    figures.tasks_done += one.task && one.task->is_done() ? 1U : 0U;
    figures.forecasts.add(one, one.lift);
    figures.load_directions += one.load_directions.size();
    for (const HoldResult& hold : one.load_directions) {
      figures.load_directions_held += hold.is_held() ? 1U : 0U;
      if (!hold.is_held()) ++figures.direction_failures[std::string(name_of(hold.failure))];
    }
  }
  const auto median_held = [&](Quantity q) { return math::median(values_of(result, true, q)); };
  const auto median = [&](Quantity q) { return math::median(values_of(result, false, q)); };
  const auto maximum = [&](Quantity q) {
    const std::vector<double> values = values_of(result, false, q);
    return values.empty() ? kUnknown : *std::ranges::max_element(values);
  };
  figures.droop_m = median_held([](const Rollout& r) { return r.lift.droop.distance_m; });
  figures.slip_m = median_held([](const Rollout& r) { return r.lift.slip_m; });
  figures.drift_m = median_held([](const Rollout& r) { return r.lift.drift.distance_m; });
  figures.palm_offset_m =
      task_median(result, [](const TaskResult& t) { return t.palm_offset.distance_m; });
  figures.palm_offset_deg =
      task_median(result, [](const TaskResult& t) { return t.palm_offset.angle_deg; });
  figures.place_error_m =
      task_median(result, [](const TaskResult& t) { return t.place_error.distance_m; });
  figures.tilt_deg = task_median(result, [](const TaskResult& t) { return t.tilt_deg; });
  figures.arm_error = maximum([](const Rollout& r) { return r.arm_error; });
  figures.hand_error = maximum([](const Rollout& r) { return r.hand_error; });
  figures.torque_ratio = maximum([](const Rollout& r) { return r.torque_ratio; });
  figures.required_force_N = median([](const Rollout& r) { return r.lift.required_force_N; });
  figures.commanded_force_N = median([](const Rollout& r) { return r.commanded_force_N; });
  std::vector<double> delays;
  for (const Rollout& one : result.rollouts)
    if (std::isfinite(one.contact_s)) delays.push_back(one.contact_s - result.planned_contact_s);
  figures.contact_delay_s = math::median(std::move(delays));
  return figures;
}

}  // namespace morphe::simulate
