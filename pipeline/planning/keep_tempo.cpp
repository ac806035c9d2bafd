#include "pipeline/planning/keep_tempo.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/statistics.hpp"
#include "pipeline/planning/constants.hpp"
#include "pipeline/planning/re_solve.hpp"
#include "pipeline/planning/repair_movement.hpp"
#include "stages/certify/goal_errors.hpp"
#include "stages/check/check_path.hpp"
#include "stages/map/re_solve_path.hpp"
#include "stages/retime/retime.hpp"

namespace morphe::planning {
namespace {

using repair::CheckedPath;

/// The figures of a path's trajectory by which it is kept.
struct TempoMeasures {
  double duration_ratio = kInfinity;
  double tip_error_m = 0;  ///< mean over samples and tips
};

TempoMeasures measure_tempo(const PlanningInputs& planner, const Plan& plan,
                            const JointPath& path) {
  const Outcome<retime::RetimeResult> retimed =
      retime::retime(planner.robot, path, plan.movement, planner.config.retime);
  const double human_s = path.demonstration_time.back() - path.demonstration_time.front();
  if (retimed.failure || !(human_s > 0)) return {};
  const Trajectory& trajectory = retimed.value.trajectory;
  return {
      trajectory.time.back() / human_s,
      certify::goal_errors(planner.robot, plan.goals, plan.movement, plan.tolerances, trajectory)
          .position_mean};
}

double mean_mapped_error(const MappingResult& mapped) {
  const JointRows& error = mapped.tip_error;
  return math::mean({error.data(), error.data() + error.size()});
}

/// Returns the factor on the cost of motion that may bring the duration to the allowed one.
double cost_step(double duration_ratio, double max_duration_ratio) {
  const double excess = (duration_ratio - 1) / (max_duration_ratio - 1);
  return std::clamp(std::pow(excess, kTempoRoot), kMinCostStep, kMaxCostStep);
}

map::MovementCost scaled_cost(double factor, const map::MovementCost& cost) {
  return {factor * cost.velocity, factor * cost.acceleration, factor * cost.jerk};
}

/// Returns the path solved again as a whole, and freed again where it collides.
CheckedPath re_solve_whole(const ReSolveContext& context, const JointPath& path) {
  map::MapOptions options = context.options;
  options.movement_solver.relative_tolerance *= kCoarseToleranceFactor;
  CheckedPath solved;
  solved.path = map::re_solve_between(with_clearance_weights(context.whole, kTempoWeights), path,
                                      path.demonstration_time.front(),
                                      path.demonstration_time.back(), options);
  solved.findings = context.check(solved.path);
  return repair::run_strategies(first_re_solves(context), std::move(solved)).candidate;
}

/// Returns the record of an attempt for the plan.
RepairStep tempo_step(double factor, const Plan& plan, const TempoMeasures& best,
                      const CheckedPath& solved, const TempoMeasures& measures, bool too_far,
                      bool accepted) {
  RepairStep step = repair::make_repair_step(fmt::format("tempo, cost of motion x {:.1f}", factor),
                                             {plan.path, {}}, {solved}, accepted);
  step.stop_reason = fmt::format("{:.2f} times the person's duration instead of {:.2f}",
                                 measures.duration_ratio, best.duration_ratio);
  if (too_far) step.stop_reason += ", but the tips are too far from their goals";
  return step;
}

}  // namespace

Plan keep_tempo(const PlanningInputs& planner, const PlacedMovement& placed,
                const collision::CollisionWorld& world, Plan plan) {
  const PipelineConfig& config = planner.config;
  if (!config.repair.tempo || plan.path.position.rows() < 2) return plan;
  const repair::TempoOptions& tempo = *config.repair.tempo;
  const map::MappingProblem whole = whole_problem(placed.problem, world);
  const collision::CollisionWorld world_with_margin = with_extra_margin(world);
  const repair::PathCheck check = [&](const JointPath& path) {
    return check::check_path(world_with_margin, plan.goals, plan.movement, path, config.check);
  };
  TempoMeasures best = measure_tempo(planner, plan, plan.path);
  const double max_error_m =
      tempo.max_tip_error_ratio * std::max(best.tip_error_m, mean_mapped_error(plan.mapped));
  map::MapOptions options = config.map;
  double factor = 1;
  for (int k = 0; k < kMaxCostSteps && best.duration_ratio > tempo.max_duration_ratio; ++k) {
    factor *= cost_step(best.duration_ratio, tempo.max_duration_ratio);
    options.movement_cost = scaled_cost(factor, config.map.movement_cost);
    CheckedPath solved = re_solve_whole({whole, options, check}, plan.path);
    const TempoMeasures measures = measure_tempo(planner, plan, solved.path);
    const bool too_far = measures.tip_error_m > max_error_m;
    const bool accepted =
        solved.findings.empty() && !too_far && measures.duration_ratio < best.duration_ratio;
    plan.repair.push_back(tempo_step(factor, plan, best, solved, measures, too_far, accepted));
    if (too_far) break;
    if (!accepted) continue;
    best = measures;
    plan.path = std::move(solved.path);
    plan.repaired = true;
  }
  return plan;
}

}  // namespace morphe::planning
