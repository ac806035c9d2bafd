#include "pipeline/study/repair_case.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/collision/certified.hpp"
#include "core/collision/fcl_engine.hpp"
#include "core/math/seed.hpp"
#include "pipeline/planning/plan_movement.hpp"
#include "pipeline/study/obstacles.hpp"
#include "stages/certify/goal_errors.hpp"
#include "stages/repair/detour.hpp"

namespace morphe::study {
namespace {

/// One movement of a recording, before anything is planned.
struct Recorded {
  Demonstration demonstration;
  HumanMotion motion;
  Movement movement;
};

Recorded recorded_movement(const RepairStudy& study, const planning::PipelineConfig& config,
                           std::uint64_t index) {
  Recorded recorded{
      synthesize::synthesize(study.synthetic, study.options.seed, index).recorded, {}, {}};
  recorded.motion =
      reconstruct::reconstruct(recorded.demonstration, config.reconstruct, config.human);
  const std::vector<Movement> movements =
      segment::segment(recorded.motion, config.segment, recorded.demonstration.objects);
  if (!movements.empty()) recorded.movement = movements.front();
  return recorded;
}

Plan plan_with(const planning::LoadedConfig& loaded,
               const std::optional<scene::ConfiguredObject>& obstacle, const Recorded& recorded) {
  planning::PipelineConfig config = loaded.options;
  if (obstacle) config.scene.objects.push_back(*obstacle);
  const planning::Planner planner{config, loaded.robot};
  planning::StageSeconds seconds;
  return planning::plan_movement(planner, recorded.demonstration, recorded.motion,
                                 recorded.movement, seconds);
}

/// FCL alone, no margin, at states between which no body moves farther than `step_m`.
void look_for_collisions(const robot::Robot& robot, const Plan& plan, const Trajectory& trajectory,
                         double step_m, Repaired& repaired) {
  Tolerances touching = plan.tolerances;
  touching.margin = 0;
  const collision::CollisionWorld world =
      collision::make_world(robot, plan.scene, plan.movement, touching);
  collision::FclEngine engine(world);
  collision::CollisionScratch scratch;
  for (std::size_t i = 1; i < trajectory.samples(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const JointVector from = trajectory.position.row(row - 1), to = trajectory.position.row(row);
    const double travel_m = (robot.capsule_levers * (to - from).cwiseAbs()).maxCoeff();
    const int steps = std::max(1, static_cast<int>(std::ceil(travel_m / step_m)));
    for (int k = 0; k < steps; ++k) {
      const double share = static_cast<double>(k) / steps;
      const double from_s = trajectory.demonstration_time[i - 1];
      const double time_s = from_s + share * (trajectory.demonstration_time[i] - from_s);
      repaired.collisions += engine.free(from + share * (to - from), time_s, scratch) ? 0 : 1;
      ++repaired.states;
    }
  }
}

Repaired check(const RepairStudy& study, const robot::Robot& robot, const Plan& plan) {
  Repaired repaired;
  repaired.executable = plan.executable();
  repaired.failure =
      plan.executable() ? "" : fmt::format("{} ({})", name_of(plan.reason), plan.detail);
  if (!repaired.executable) return repaired;
  Trajectory untimed;
  untimed.time = untimed.demonstration_time = plan.path.demonstration_time;
  untimed.position = plan.path.position;
  const certify::GoalErrors errors =
      certify::goal_errors(robot, plan.goals, plan.movement, plan.tolerances, untimed);
  repaired.a_ratio = errors.humanlikeness / plan.certificate.humanlikeness_mapped;
  repaired.tips_m = errors.position_mean;
  for (std::size_t k = 0; k < plan.path.origin.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    repaired.outside_changed |= plan.path.origin[k] == Origin::mapped &&
                                plan.path.position.row(row) != plan.mapped.position.row(row);
  }
  look_for_collisions(robot, plan, plan.trajectory.samples() > 0 ? plan.trajectory : untimed,
                      study.options.step_m, repaired);
  return repaired;
}

/// What a planner alone makes of the path that was free before the obstacle came.
Plan repair_plainly(const planning::LoadedConfig& loaded, const Plan& undisturbed,
                    const Plan& disturbed, std::uint64_t seed) {
  Plan plan = undisturbed;
  plan.scene = disturbed.scene;
  plan.trajectory = {};
  const collision::CollisionWorld world =
      collision::make_world(loaded.robot, plan.scene, plan.movement, plan.tolerances);
  const repair::Check check = [&](const JointPath& path) {
    return check::check_path(world, plan.goals, plan.movement, path, loaded.options.check);
  };
  const repair::Surroundings around{world, loaded.options.repair, seed, check, {}};
  const repair::Checked start{plan.path, check(plan.path)};
  const repair::Rung a_detour{
      "detour", [&](const repair::Checked& best) { return repair::detour(around, best); }};
  const Outcome<repair::RepairResult> repaired = repair::repair_path({a_detour}, start);
  plan.path = repaired.value.path;
  plan.reason = repaired.refusal.reason;
  plan.detail = repaired.refusal.detail;
  return plan;
}

}  // namespace

ObstacleCase run_case(const RepairStudy& study, const std::vector<planning::LoadedConfig>& variants,
                      const planning::LoadedConfig& plain,
                      const std::vector<planning::LoadedConfig>& long_searches,
                      std::uint64_t index) {
  ObstacleCase result;
  result.recording = index;
  result.kind = kObstacleKinds[index % std::size(kObstacleKinds)];
  const planning::LoadedConfig& ours = variants.front();
  const Recorded recorded = recorded_movement(study, ours.options, index);
  if (recorded.movement.phases.empty()) return result;
  const Plan undisturbed = plan_with(ours, std::nullopt, recorded);
  if (!undisturbed.executable()) return result;
  const std::uint64_t seed =
      math::seed_from(study.options.seed, fmt::format("{}/{}", index, result.kind));
  const Pose world_from_base =
      map::place_robot(ours.robot, map::shoulder_at_begin(recorded.motion, recorded.movement),
                       ours.options.placement);
  const std::optional<scene::ConfiguredObject> obstacle =
      obstacle_in_the_way(ours.robot, undisturbed, world_from_base, result.kind, seed);
  if (!obstacle) return result;
  result.exists = true;
  Plan disturbed;
  for (const planning::LoadedConfig& variant : variants) {
    disturbed = plan_with(variant, obstacle, recorded);
    result.variants.push_back(check(study, ours.robot, disturbed));
  }
  result.variants.push_back(
      check(study, ours.robot, repair_plainly(plain, undisturbed, disturbed, seed)));
  if (result.variants.front().executable) return result;
  for (const planning::LoadedConfig& search : long_searches) {
    if (result.found_by_long_search) break;
    result.found_by_long_search = plan_with(search, obstacle, recorded).executable();
  }
  return result;
}

}  // namespace morphe::study
