#include <algorithm>
#include <cmath>

#include "core/math/statistics.hpp"
#include "core/motion/goal_interpolation.hpp"
#include "core/parallel/for_each.hpp"
#include "pipeline/place/place.hpp"
#include "pipeline/place/reachability_grid.hpp"
#include "pipeline/planning/place_movement.hpp"

namespace morphe::place {
namespace {

struct MovementResult {
  PlacementMeasures measures;
  bool executable = false;
  double tip_error_max_m = kUnknown;
};

MovementResult plan_one(const planning::PlanningInputs& planner, const TrialMovement& trial) {
  const planning::Reconstruction& reconstruction = *trial.reconstruction;
  const Plan plan =
      planning::plan_movement(planner, reconstruction.on_robot_side, reconstruction.motion,
                              reconstruction.movements[trial.index]);
  MovementResult result;
  result.executable = plan.executable();
  result.measures.collision_share = 1;
  if (plan.mapped.position.rows() > 0) {
    const planning::PlacedMovement placed(planner, trial.motion, trial.movement, trial.surroundings,
                                          plan.goals.base_offset.value_or(Vec3::Zero()));
    result.measures = measure(placed.problem, plan.mapped.position);
    result.measures.out_of_reach = count_goals(plan.goals).share_out_of_reach();
    result.measures.collision_share = plan.has_trajectory() ? 0 : 1;
  }
  if (plan.has_trajectory()) {
    result.measures.penetration_m = 0;
    result.measures.speed_ratio = plan.certificate.duration_ratio;
    result.tip_error_max_m = plan.certificate.tip_error_max;
    if (!std::isnan(plan.certificate.upper_arm_error_mean))
      result.measures.upper_arm_error = plan.certificate.upper_arm_error_mean;
  }
  return result;
}

}  // namespace

PlacementResult plan_with_placement(const planning::PlanningInputs& planner,
                                    const std::vector<TrialMovement>& trials,
                                    const map::PlacementOptions& placement, int jobs) {
  planning::PipelineConfig config = planner.config;
  config.placement = placement;
  const planning::PlanningInputs inputs{config, planner.robot};
  std::vector<PlacementMeasures> all;
  std::vector<double> upper_arm;
  const int count = static_cast<int>(trials.size());
  PlacementResult placed;
  placed.placement = placement;
  placed.base_placement = base_placement_of(placement);
  parallel::ordered_for_each<MovementResult>(
      count, jobs, [&](std::uint64_t k) { return plan_one(inputs, trials[k]); },
      [&](const MovementResult& one) {
        all.push_back(one.measures);
        upper_arm.push_back(one.measures.upper_arm_error);
        placed.plan_summary.executable += one.executable ? 1 : 0;
        placed.plan_summary.tip_error_max_m =
            std::fmax(placed.plan_summary.tip_error_max_m, one.tip_error_max_m);
      });
  placed.plan_summary.movements = count;
  placed.plan_summary.measures = mean_of(all);
  placed.plan_summary.upper_arm_error_median = math::midpoint_median(upper_arm);
  placed.plan_summary.upper_arm_error_max = std::ranges::max(upper_arm);
  placed.base = base_from_human_shoulder(placed.base_placement, map::robot_shoulder(planner.robot));
  double sum = 0;
  int tables = 0;
  for (const TrialMovement& trial : trials) {
    if (const SceneObject* table = trial.table()) {
      sum +=
          trial.shoulder.z() + placed.base.z() - table->position.front().z() - table->size[2] / 2;
      ++tables;
    }
  }
  if (tables > 0) placed.height_above_table = sum / tables;
  return placed;
}

}  // namespace morphe::place
