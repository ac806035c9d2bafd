#pragma once

#include <string>
#include <vector>

#include "stages/simulate/prepare.hpp"

namespace morphe::simulate {

/// Rollout k of a plan: of 0 nothing is varied; of the others friction (and torsion with it) and
/// mass by up to kFactor, or over the ranges that the options name, the target's place by up to
/// kShift_m along each of two directions of the plane it stands on and kTurn_deg about its normal,
/// evenly. Depends on the seed, the plan's name
/// ("<demonstration>/<000>") and k alone.
Variation variation_of(const PreparedPlan& plan, const SimulateOptions& options,
                       const std::string& name, int k);

/// What became of a plan.
struct PlanResult {
  std::string plan;         ///< "<demonstration>/<000>"
  std::string plan_sha256;  ///< store::fingerprint of it
  Unfit unfit = Unfit::none;
  std::string detail;
  std::vector<std::string> notes;
  std::vector<Press> presses;
  std::vector<std::string> tips;  ///< [presses] their names
  bool planned_squeeze = false;   ///< Squeeze::planned
  double force_share = 1;         ///< Squeeze::force_share
  double planned_contact_s = kNotSeen;
  std::vector<Rollout> rollouts;  ///< [ensemble], none if it is unfit

  std::size_t held() const;
};

/// Rollouts run on the idle threads of a parallel::run around it, if there is one.
PlanResult simulate_plan(const robot::Robot& robot, const Plan& plan, const std::string& name,
                         const SimulateOptions& options);

/// What a result depends on, as SHA-256: the plan, the robot, the options, the engine, and whatever
/// else `program` names.
std::string key_of(const RobotTable& robot, const Plan& plan, const SimulateOptions& options,
                   const std::string& program);

}  // namespace morphe::simulate
