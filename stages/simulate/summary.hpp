#pragma once

#include <map>
#include <string>

#include "stages/simulate/ensemble.hpp"

namespace morphe::simulate {

using FailureCounts = std::map<std::string, int>;  ///< by cause

/// The number of applied loads whose forecast was holds or falls, and of those that were foretold
/// right; and the number of those near their limit, and of those that were held.
struct ForecastCount {
  std::size_t clear = 0, correct = 0, near_limit = 0, near_limit_held = 0;
  /// Counts a load, if it was applied.
  void add(const Rollout& one, const HoldResult& load) {
    if (!reached_load_test(load.failure)) return;
    const Forecast forecast = one.forecast(load);
    const bool is_near = forecast == Forecast::near_limit;
    ++(is_near ? near_limit : clear);
    if (is_near)
      near_limit_held += load.is_held() ? 1U : 0U;
    else
      correct += (forecast == Forecast::holds) == load.is_held() ? 1U : 0U;
  }
};

/// The summary of a plan's rollouts. NaN if there are no rollouts to which a value applies.
struct SimulationSummary {
  std::size_t held = 0, load_directions_held = 0, load_directions = 0;
  std::size_t tasks = 0, tasks_done = 0;  ///< rollouts of a plan that carries its target
  double droop_m = kUnknown, slip_m = kUnknown, drift_m = kUnknown;  ///< medians of held rollouts
  double arm_error = kUnknown, hand_error = kUnknown, torque_ratio = kUnknown;  ///< largest
  double contact_delay_s = kUnknown;  ///< median time of the first touch less the planned time
  /// medians of the tasks whose target was held until the release
  double palm_offset_m = kUnknown, palm_offset_deg = kUnknown, place_error_m = kUnknown,
         tilt_deg = kUnknown;
  double required_force_N = kUnknown, commanded_force_N = kUnknown;  ///< medians, during the lift
  ForecastCount forecasts;                                           ///< for the lift
  FailureCounts failures, direction_failures;
};
/// Summarises the rollouts of a plan.
SimulationSummary summarise(const PlanResult& result);

}  // namespace morphe::simulate
