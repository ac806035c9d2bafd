#pragma once

#include <map>
#include <string>

#include "stages/simulate/ensemble.hpp"

namespace morphe::simulate {

using FailureCounts = std::map<std::string, int>;  ///< by cause

/// The number of applied loads, and of those for which the required force told hold from fall.
struct PredictionCount {
  std::size_t correct_count = 0, total = 0;
  /// Counts a load, if it was applied.
  void add(const Rollout& one, const HoldResult& load) {
    if (!reached_load_test(load.failure)) return;
    ++total;
    correct_count += one.predicts_hold(load) == load.is_held() ? 1U : 0U;
  }
};

/// The summary of a plan's rollouts. NaN if there are no rollouts to which a value applies.
struct SimulationSummary {
  std::size_t held = 0, load_directions_held = 0, load_directions = 0;
  double droop_m = kUnknown, slip_m = kUnknown, drift_m = kUnknown;  ///< medians of held rollouts
  double arm_error = kUnknown, hand_error = kUnknown, torque_ratio = kUnknown;  ///< largest
  double contact_delay_s = kUnknown;  ///< median time of the first touch less the planned time
  double required_force_N = kUnknown, commanded_force_N = kUnknown;  ///< medians, during the lift
  PredictionCount correct_predictions;                               ///< predictions for the lift
  FailureCounts failures, direction_failures;
};
/// Summarises the rollouts of a plan.
SimulationSummary summarise(const PlanResult& result);

}  // namespace morphe::simulate
