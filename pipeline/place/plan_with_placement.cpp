#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/math/statistics.hpp"
#include "core/motion/goal_interpolation.hpp"
#include "core/parallel/for_each.hpp"
#include "pipeline/place/constants.hpp"
#include "pipeline/place/place.hpp"
#include "pipeline/place/reachability_grid.hpp"
#include "pipeline/planning/place_movement.hpp"

namespace morphe::place {
namespace {

struct MovementResult {
  std::optional<PlacementMeasures> measures;  ///< empty if the movement was not mapped
  bool executable = false, has_trajectory = false;
  double tip_error_max_m = kUnknown;
  std::string failure;  ///< of a movement that was not mapped
};

/// Measures of a movement that misses every goal by the most and turns away from the person.
constexpr PlacementMeasures kNothingMapped{
    1, kMaxTipError_m, 1, 0, std::numbers::pi, std::numbers::pi, 1, 0};

std::string failure_text(const Plan& plan) {
  return fmt::format("{}/{:03} ({}: {})", plan.demonstration, plan.movement.index,
                     name_of(plan.reason), plan.detail);
}

MovementResult plan_one(const planning::PlanningInputs& planner, const TrialMovement& trial) {
  const planning::Reconstruction& reconstruction = *trial.reconstruction;
  const Plan plan =
      planning::plan_movement(planner, reconstruction.on_robot_side, reconstruction.motion,
                              reconstruction.movements[trial.index]);
  MovementResult result;
  result.executable = plan.executable();
  result.has_trajectory = plan.has_trajectory();
  if (plan.mapped.position.rows() == 0) {
    result.failure = failure_text(plan);
    return result;
  }
  const planning::PlacedMovement placed(planner, trial.motion, trial.movement, trial.surroundings,
                                        plan.goals.base_offset.value_or(Vec3::Zero()));
  PlacementMeasures measures = measure(placed.problem, plan.mapped.position);
  measures.out_of_reach = count_goals(plan.goals).share_out_of_reach();
  if (plan.has_trajectory()) {
    measures.penetration_m = 0;
    measures.speed_ratio = plan.certificate.duration_ratio;
    result.tip_error_max_m = plan.certificate.tip_error_max;
    if (!std::isnan(plan.certificate.upper_arm_error_mean))
      measures.upper_arm_error = plan.certificate.upper_arm_error_mean;
  }
  result.measures = measures;
  return result;
}

PlannedSummary summary_of(const std::vector<MovementResult>& all) {
  PlannedSummary summary;
  std::vector<PlacementMeasures> mapped;
  std::vector<double> upper_arm;
  int trajectories = 0;
  for (const MovementResult& one : all) {
    if (one.measures) mapped.push_back(*one.measures);
    if (!one.measures) summary.failed_before_mapping.push_back(one.failure);
    summary.executable += one.executable ? 1 : 0;
    trajectories += one.has_trajectory ? 1 : 0;
    summary.tip_error_max_m = std::fmax(summary.tip_error_max_m, one.tip_error_max_m);
  }
  if (mapped.empty()) mapped.push_back(kNothingMapped);
  for (const PlacementMeasures& one : mapped) upper_arm.push_back(one.upper_arm_error);
  summary.movements = static_cast<int>(all.size());
  summary.measures = mean_of(mapped);
  summary.measures.collision_share =
      1 - static_cast<double>(trajectories) / static_cast<double>(all.size());
  summary.upper_arm_error_median = math::midpoint_median(upper_arm);
  summary.upper_arm_error_max = std::ranges::max(upper_arm);
  return summary;
}

/// Returns the mean height of the base above the tables of the trials; unknown without tables.
double height_above_tables(const std::vector<TrialMovement>& trials, const Vec3& base) {
  double sum = 0;
  int tables = 0;
  for (const TrialMovement& trial : trials) {
    const SceneObject* table = trial.table();
    if (!table) continue;
    sum += trial.shoulder.z() + base.z() - table->position.front().z() - table->size[2] / 2;
    ++tables;
  }
  return tables > 0 ? sum / tables : kUnknown;
}

}  // namespace

double plan_cost(const PlacementResult& placed) { return cost_of(placed.plan_summary.measures); }

PlacementResult plan_with_placement(const planning::PlanningInputs& planner,
                                    const std::vector<TrialMovement>& trials,
                                    const map::PlacementOptions& placement, int jobs) {
  planning::PipelineConfig config = planner.config;
  config.placement = placement;
  const planning::PlanningInputs inputs{config, planner.robot};
  std::vector<MovementResult> all;
  parallel::ordered_for_each<MovementResult>(
      static_cast<int>(trials.size()), jobs,
      [&](std::uint64_t k) { return plan_one(inputs, trials[k]); },
      [&](const MovementResult& one) { all.push_back(one); });
  PlacementResult placed;
  placed.placement = placement;
  placed.base_placement = base_placement_of(placement);
  placed.plan_summary = summary_of(all);
  placed.base = base_from_human_shoulder(placed.base_placement, map::robot_shoulder(planner.robot));
  placed.height_above_table = height_above_tables(trials, placed.base);
  return placed;
}

}  // namespace morphe::place
