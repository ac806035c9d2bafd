#include "pipeline/planning/repair_movement.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "core/motion/finding_text.hpp"
#include "pipeline/planning/candidate_sources.hpp"
#include "pipeline/planning/constants.hpp"
#include "pipeline/planning/infeasible_frame.hpp"
#include "pipeline/planning/re_solve.hpp"
#include "stages/check/check_path.hpp"
#include "stages/repair/candidate_strategy.hpp"
#include "stages/repair/detour.hpp"

namespace morphe::planning {
namespace {

using repair::CheckedPath;
using repair::RepairStrategy;

/// Returns why no path of the robot can help: the target, which moves as it was recorded, meets
/// another object while it is carried.
PlanningFailure collision_on_recorded_way(const Plan& plan) {
  const SceneObject* target = find_object(plan.scene.objects, plan.movement.target);
  if (!target || !target->attached_frame.empty()) return {};
  std::vector<Finding> findings = plan.findings;
  std::erase_if(findings, [&](const Finding& finding) {
    return !is_collision(finding.cause) || finding.subject != target->name;
  });
  const Finding* worst = repair::worst_finding(findings);
  if (!worst) return {};
  return {Reason::goal_in_collision,
          fmt::format("{}; {} is carried as it was recorded, so no path of the robot avoids this: "
                      "move {}, or let a detour carry {} with scene.target.carried_by=palm",
                      sentence(*worst), target->name, worst->other_body, target->name)};
}

}  // namespace

collision::CollisionWorld with_extra_margin(collision::CollisionWorld world) {
  world.tolerances.required_clearance += kExtraMargin_m;
  return world;
}

Outcome<repair::RepairResult> repair_movement(const PlanningInputs& planner,
                                              const PlacedMovement& placed,
                                              const collision::CollisionWorld& world,
                                              const Plan& plan, const map::MapResult& mapped,
                                              std::uint64_t seed) {
  const PipelineConfig& config = planner.config;
  if (PlanningFailure failure = collision_on_recorded_way(plan))
    return {{plan.path, false, plan.findings, {}}, std::move(failure)};
  const map::MappingProblem whole = whole_problem(placed.problem, world);
  const auto findings_in = [&](const collision::CollisionWorld& tested, const JointPath& path) {
    return check::check_path(tested, plan.goals, plan.movement, path, config.check);
  };
  const repair::PathCheck check = [&](const JointPath& path) { return findings_in(world, path); };
  const collision::CollisionWorld world_with_margin = with_extra_margin(world);
  const repair::PathCheck check_with_margin = [&](const JointPath& path) {
    return findings_in(world_with_margin, path);
  };

  const CheckedPath mapped_path{plan.path, plan.findings};
  const ReSolveContext re_solving{whole, config.map, check_with_margin};
  std::vector<FeasiblePosture> postures;  // in the frames of findings
  repair::CandidateFindings tried;
  repair::DetourContext detours{world, config.repair, seed, check_with_margin, {}};

  const RepairStrategy detour{
      "detour", [&](const CheckedPath& best) { return repair::detour(detours, best); }};
  std::vector<RepairStrategy> strategies{detour};
  if (config.repair.method == repair::Method::humanlike) {
    detours.tracking_recovery = first_re_solves(re_solving);
    detours.tracking_recovery.push_back(repair::only_if_nearly_free(re_solve_strongly(re_solving)));
    const RepairStrategy stop_if_dead_end{
        "look for an infeasible frame", [&](const CheckedPath& best) {
          const bool tips_count = config.map.mode != map::MapMode::joint_to_joint;
          if (!tips_count) return repair::StrategyResult{best, {}, false, "skipped (no tip goals)"};
          return stop_if_infeasible(whole, best, check, config.map, seed, postures);
        }};
    const RepairStrategy detour_from_mapped{
        "detour from the mapped path", [&](const CheckedPath& best) {
          return repair::detour_from_mapped(mapped_path, detours, best);
        }};
    std::vector<RepairStrategy> re_solves_and_detour = detours.tracking_recovery;
    re_solves_and_detour.push_back(repair::detour_if_only_collisions(detours));
    const std::vector<RepairStrategy> later_strategies{
        stop_if_dead_end,
        re_solve_strongly(re_solving),
        repair::candidate_strategy("paths through collision-free postures",
                                   detours.tracking_recovery, check_with_margin,
                                   candidates_through_postures(whole, config.map, postures), tried),
        repair::candidate_strategy("other paths of the mapping", detours.tracking_recovery,
                                   check_with_margin, mapping_candidates(whole, mapped.candidates),
                                   tried),
        detour,
        detour_from_mapped,
        repair::candidate_strategy(
            "other paths of new mapping searches", std::move(re_solves_and_detour),
            check_with_margin,
            searched_candidates(whole, config.map, config.repair.mapping_searches, seed), tried),
    };
    strategies = first_re_solves(re_solving);
    strategies.insert(strategies.end(), later_strategies.begin(), later_strategies.end());
  }
  Outcome<repair::RepairResult> repaired = repair::repair_path(strategies, mapped_path);
  if (repaired.failure.reason == Reason::no_path) {
    repaired.failure.detail += "; " + repair::no_path_message(config.repair);
  }
  if (repaired.failure && check(repaired.value.path).empty()) {
    return {{std::move(repaired.value.path), true, {}, std::move(repaired.value.attempts)}, {}};
  }
  return repaired;
}

}  // namespace morphe::planning
