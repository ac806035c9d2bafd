#pragma once

#include <optional>
#include <vector>

#include "stages/simulate/hold_result.hpp"
#include "stages/simulate/prepared_plan.hpp"

namespace morphe::simulate {

/// The result of one rollout.
struct Rollout {
  Variation variation;
  double arm_error = 0, hand_error = 0;  ///< largest until the first touch [degrees or mm]
  double contact_s = 0;  ///< time of the first touch since the start [s]; NaN without a touch
  Displacement pregrasp_displacement;  ///< largest in the base's frame until the target is squeezed
  double torque_ratio = 0;             ///< largest ratio of a motor's torque to its limit
  /// commanded force, and those required by statics (force_prediction.hpp)
  double commanded_force_N = 0, required_force_gravity_N = 0, required_force_worst_N = 0;
  std::vector<double> measured_force_N;  ///< [finger_forces] on the tip's link in the squeeze
  HoldResult lift;  ///< of lifting and holding; with a task, of carrying until the release
  std::optional<TaskResult> task;  ///< if the plan carries its target
  std::vector<HoldResult>
      load_directions;  ///< along the target's -x, x, -y, y, -z, z; may be empty
  /// Returns the forecast for a load.
  Forecast forecast(const HoldResult& load) const {
    return forecast_of(load.required_force_N, commanded_force_N);
  }
};

/// Runs the test protocol once (docs/steps/simulate.md), with loads in six directions if
/// `directions` is true and the grasp succeeds. The same arguments give the same bits.
Rollout roll_out(const PreparedPlan& plan, const Variation& variation,
                 const SimulateOptions& options, bool directions);

}  // namespace morphe::simulate
