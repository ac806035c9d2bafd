#pragma once

#include <string>
#include <vector>

#include "stages/simulate/prepare.hpp"
#include "stages/simulate/rollout.hpp"

namespace morphe::simulate {

/// Returns the variation of rollout k of a plan. Rollout 0 has the nominal values. In all others,
/// friction and mass vary by up to kVariationShare, or over the options' ranges; torsional friction
/// varies in proportion to friction. The target is displaced by up to kTargetShift_m along each of
/// two directions of its support plane, and rotated by up to kTargetTurn_deg about the plane's
/// normal. The random numbers depend on seed, `name` of the plan, and k.
Variation variation_of(const PreparedPlan& plan, const SimulateOptions& options,
                       const std::string& name, std::ptrdiff_t k);

/// The result of simulating a plan.
struct PlanResult {
  std::string plan;          ///< "<demonstration>/<000>"
  std::string plan_sha256;   ///< store::fingerprint() of the plan
  std::string not_verified;  ///< why the plan was not verified before; "" if it was
  SkipReason skip_reason = SkipReason::none;
  std::string detail;
  std::vector<std::string> notes;
  std::vector<FingerForce> finger_forces;
  std::vector<std::string> tips;  ///< [finger_forces] names of the tips
  ContactSource contact_source = ContactSource::nearest;
  double force_scale = 1;  ///< GraspCommand::force_scale
  double planned_contact_s = kUnknown;
  std::vector<Rollout> rollouts;  ///< [rollouts]; empty if the plan was skipped

  /// Returns the number of rollouts in which the target was held during the lift.
  std::size_t held_count() const;
};

/// Prepares a plan called `name` and runs its rollouts, in parallel on the idle threads of an
/// enclosing parallel::run().
PlanResult simulate_plan(const robot::Robot& robot, const Plan& plan, const std::string& name,
                         const SimulateOptions& options);

/// Returns the SHA-256 of all that a result depends on: plan, robot, options, engine and `program`.
std::string result_key(const RobotModel& robot, const Plan& plan, const SimulateOptions& options,
                       const std::string& program);

}  // namespace morphe::simulate
