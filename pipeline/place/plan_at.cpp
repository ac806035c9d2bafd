#include <algorithm>
#include <cmath>

#include "core/motion/goals_at.hpp"
#include "core/parallel/for_each.hpp"
#include "pipeline/place/place.hpp"
#include "pipeline/place/reach.hpp"
#include "pipeline/planning/place_movement.hpp"

namespace morphe::place {
namespace {

struct OneMovement {
  Measures measures;
  bool executable = false;
  double tip_error_max_m = kNotSeen;
};

OneMovement plan_one(const planning::Planner& planner, const Trial& trial) {
  planning::StageSeconds ignored;
  const planning::Rebuilt& rebuilt = *trial.rebuilt;
  const Plan plan = planning::plan_movement(planner, rebuilt.beside, rebuilt.motion,
                                            rebuilt.movements[trial.index], ignored);
  OneMovement one;
  one.executable = plan.executable();
  one.measures.colliding = 1;
  if (plan.mapped.position.rows() > 0) {
    const planning::PlacedMovement placed(planner, trial.motion, trial.movement, trial.around,
                                          plan.goals.free_offset.value_or(Vec3::Zero()));
    one.measures = measure(placed.problem, plan.mapped.position);
    one.measures.out_of_reach = count_goals(plan.goals).share_out_of_reach();
    one.measures.colliding = plan.has_trajectory() ? 0 : 1;
  }
  if (plan.has_trajectory()) {
    one.measures.depth_m = 0;
    one.measures.speed = plan.certificate.tempo;
    one.tip_error_max_m = plan.certificate.position_error_max;
    if (!std::isnan(plan.certificate.upper_arm_error_mean)) {
      one.measures.upper_arm = plan.certificate.upper_arm_error_mean;
    }
  }
  return one;
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

}  // namespace

Found plan_at(const planning::Planner& planner, const std::vector<Trial>& trials,
              const map::PlacementOptions& placement, int jobs) {
  planning::PipelineConfig config = planner.config;
  config.placement = placement;
  const planning::Planner placed{config, planner.robot};
  std::vector<Measures> all;
  std::vector<double> upper_arm;
  Found found;
  found.placement = placement;
  found.stand = stand_of(placement);
  parallel::for_each<OneMovement>(
      static_cast<int>(trials.size()), jobs,
      [&](std::uint64_t k) { return plan_one(placed, trials[k]); },
      [&](const OneMovement& one) {
        all.push_back(one.measures);
        upper_arm.push_back(one.measures.upper_arm);
        found.planned.executable += one.executable ? 1 : 0;
        found.planned.tip_error_max_m =
            std::fmax(found.planned.tip_error_max_m, one.tip_error_max_m);
      });
  found.planned.movements = static_cast<int>(trials.size());
  found.planned.measures = mean_of(all);
  found.planned.upper_arm_median = median(upper_arm);
  found.planned.upper_arm_max = std::ranges::max(upper_arm);
  found.base = base_from_human_shoulder(found.stand, map::robot_shoulder(planner.robot));
  double sum = 0;
  int tables = 0;
  for (const Trial& trial : trials) {
    if (const SceneObject* table = trial.table()) {
      sum += trial.shoulder.z() + found.base.z() - table->position.front().z() - table->size[2] / 2;
      ++tables;
    }
  }
  if (tables > 0) found.above_table = sum / tables;
  return found;
}

}  // namespace morphe::place
