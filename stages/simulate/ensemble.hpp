#pragma once

#include <string>
#include <vector>

#include "stages/simulate/prepare.hpp"

namespace morphe::simulate {

/// Returns the variation of rollout k of a plan. Rollout 0 has the nominal values. In all others,
/// friction (and torsion with it) and mass vary by up to kVariationShare, or over the ranges given
/// in the options; the target's position varies uniformly by up to kTargetShift_m along each of two
/// directions of its support plane, and its orientation by up to kTargetTurn_deg about the plane's
/// normal. Depends only on the seed, the plan's name ("<demonstration>/<000>") and k.
Variation variation_of(const PreparedPlan& plan, const SimulateOptions& options,
                       const std::string& name, int k);

/// The result of simulating a plan.
struct PlanResult {
  std::string plan;         ///< "<demonstration>/<000>"
  std::string plan_sha256;  ///< store::fingerprint() of the plan
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

/// Prepares a plan and runs its rollouts, on the idle threads of an enclosing parallel::run() if
/// there is one.
PlanResult simulate_plan(const robot::Robot& robot, const Plan& plan, const std::string& name,
                         const SimulateOptions& options);

/// Returns the SHA-256 of everything on which a result depends: the plan, the robot, the options,
/// the engine, and any further dependencies named in `program`.
std::string result_key(const RobotModel& robot, const Plan& plan, const SimulateOptions& options,
                       const std::string& program);

}  // namespace morphe::simulate
