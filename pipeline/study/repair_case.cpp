#include "pipeline/study/repair_case.hpp"

#include <fmt/format.h>

#include "core/math/seed.hpp"
#include "pipeline/planning/plan_movement.hpp"
#include "pipeline/study/colliding_states.hpp"
#include "pipeline/study/obstacles.hpp"
#include "stages/certify/goal_errors.hpp"
#include "stages/repair/detour.hpp"

namespace morphe::study {
namespace {

struct RecordedMovement {
  Demonstration demonstration;
  HumanMotion motion;
  Movement movement;
};

RecordedMovement recorded_movement(const RepairStudy& study, const planning::PipelineConfig& config,
                                   std::uint64_t index) {
  RecordedMovement recorded{
      synthesize::synthesize(study.synthetic, study.options.seed, index).recorded, {}, {}};
  recorded.motion =
      reconstruct::reconstruct(recorded.demonstration, config.reconstruct, config.human);
  const std::vector<Movement> movements = segment::segment(
      recorded.motion, config.segment, recorded.demonstration.objects, recorded.demonstration.task);
  if (!movements.empty()) recorded.movement = movements.front();
  return recorded;
}

Plan plan_with(const planning::LoadedConfig& loaded,
               const std::optional<scene::ConfiguredObject>& obstacle,
               const RecordedMovement& recorded) {
  planning::PipelineConfig config = loaded.options;
  if (obstacle) config.scene.objects.push_back(*obstacle);
  const planning::PlanningInputs planner{config, loaded.robot};
  return planning::plan_movement(planner, recorded.demonstration, recorded.motion,
                                 recorded.movement);
}

RepairOutcome score_repair(const RepairStudy& study, const robot::Robot& robot, const Plan& plan) {
  RepairOutcome repaired;
  repaired.executable = plan.executable();
  if (!repaired.executable) {
    repaired.failure = fmt::format("{} ({})", name_of(plan.reason), plan.detail);
    return repaired;
  }
  Trajectory untimed;
  untimed.time = untimed.demonstration_time = plan.path.demonstration_time;
  untimed.position = plan.path.position;
  const certify::GoalErrors errors =
      certify::goal_errors(robot, plan.goals, plan.movement, plan.tolerances, untimed);
  repaired.humanlikeness_ratio = errors.humanlikeness / plan.certificate.humanlikeness_mapped;
  repaired.mean_tip_error_m = errors.position_mean;
  for (int k = 0; k < std::ssize(plan.path.origin); ++k)
    repaired.mapped_samples_changed |= plan.path.origin[k] == SampleOrigin::mapped &&
                                       plan.path.position.row(k) != plan.mapped.position.row(k);
  repaired.colliding_states =
      count_colliding_states(robot, plan, plan.trajectory.samples() > 0 ? plan.trajectory : untimed,
                             study.options.check_step_m);
  return repaired;
}

/// Returns the plan `undisturbed`, made without the obstacle, after a repair of its path by detours
/// alone in the scene of `disturbed`, made with it. The result has no trajectory.
Plan repair_with_planner_only(const planning::LoadedConfig& loaded, const Plan& undisturbed,
                              const Plan& disturbed, std::uint64_t seed) {
  Plan plan = undisturbed;
  plan.scene = disturbed.scene;
  plan.trajectory = {};
  const collision::CollisionWorld world =
      collision::make_world(loaded.robot, plan.scene, plan.movement, plan.tolerances);
  const repair::PathCheck check = [&](const JointPath& path) {
    return check::check_path(world, plan.goals, plan.movement, path, loaded.options.check);
  };
  const repair::DetourContext context{world, loaded.options.repair, seed, check, {}};
  const repair::CheckedPath start{plan.path, check(plan.path)};
  const repair::RepairStrategy detour{
      "detour", [&](const repair::CheckedPath& best) { return repair::detour(context, best); }};
  const Outcome<repair::RepairResult> repaired = repair::repair_path({detour}, start);
  plan.path = repaired.value.path;
  plan.reason = repaired.failure.reason;
  plan.detail = repaired.failure.detail;
  return plan;
}

}  // namespace

ObstacleCase run_case(const RepairStudy& study, const std::vector<planning::LoadedConfig>& variants,
                      const planning::LoadedConfig& planner_only,
                      const std::vector<planning::LoadedConfig>& long_searches,
                      std::uint64_t index) {
  ObstacleCase result;
  result.recording = index;
  result.kind = kObstacleKinds[index % std::size(kObstacleKinds)];
  const planning::LoadedConfig& ours = variants.front();
  const RecordedMovement recorded = recorded_movement(study, ours.options, index);
  if (recorded.movement.phases.empty()) return result;
  const Plan free_plan = plan_with(ours, std::nullopt, recorded);
  if (!free_plan.executable()) return result;
  const std::uint64_t seed =
      math::seed_from(study.options.seed, fmt::format("{}/{}", index, result.kind));
  const Pose world_from_base =
      map::place_robot(ours.robot, map::shoulder_at_begin(recorded.motion, recorded.movement),
                       ours.options.placement);
  const std::optional<scene::ConfiguredObject> obstacle =
      draw_blocking_obstacle(ours.robot, free_plan, world_from_base, result.kind, seed);
  if (!obstacle) return result;
  result.is_valid = true;
  Plan obstructed_plan;
  for (const planning::LoadedConfig& variant : variants) {
    obstructed_plan = plan_with(variant, obstacle, recorded);
    result.variants.push_back(score_repair(study, ours.robot, obstructed_plan));
  }
  result.variants.push_back(score_repair(
      study, ours.robot, repair_with_planner_only(planner_only, free_plan, obstructed_plan, seed)));
  if (result.variants.front().executable) return result;
  for (const planning::LoadedConfig& search : long_searches) {
    if (result.found_by_long_search) break;
    result.found_by_long_search = plan_with(search, obstacle, recorded).executable();
  }
  return result;
}

}  // namespace morphe::study
