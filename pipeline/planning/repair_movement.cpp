#include "pipeline/planning/repair_movement.hpp"

#include <utility>
#include <vector>

#include "pipeline/planning/candidate_sources.hpp"
#include "pipeline/planning/infeasible_frame.hpp"
#include "pipeline/planning/re_solve.hpp"
#include "stages/check/check_path.hpp"
#include "stages/repair/candidate_strategy.hpp"
#include "stages/repair/detour.hpp"

namespace morphe::planning {
namespace {

using repair::CheckedPath;
using repair::RepairStrategy;

}  // namespace

collision::CollisionWorld with_extra_margin(collision::CollisionWorld world) {
  world.tolerances.required_clearance += 2e-4;
  return world;
}

Outcome<repair::RepairResult> repair_movement(const PlanningInputs& planner,
                                              const PlacedMovement& placed,
                                              const collision::CollisionWorld& world,
                                              const Plan& plan, const map::MapResult& mapped,
                                              std::uint64_t seed) {
  const PipelineConfig& config = planner.config;
  map::MappingProblem whole = placed.problem;
  whole.world = &world;
  const auto findings_in = [&](const collision::CollisionWorld& of, const JointPath& path) {
    return check::check_path(of, plan.goals, plan.movement, path, config.check);
  };
  const repair::PathCheck check = [&](const JointPath& path) { return findings_in(world, path); };
  const collision::CollisionWorld world_with_extra_margin = with_extra_margin(world);
  const repair::PathCheck check_with_extra_margin = [&](const JointPath& path) {
    return findings_in(world_with_extra_margin, path);
  };

  const CheckedPath warm_start{plan.path, plan.findings};
  const ReSolveContext solving{whole, config.map, check_with_extra_margin};
  std::vector<FeasiblePosture> holds;  // postures that satisfy goals at which the path failed
  repair::CandidateFindings ends;
  repair::DetourContext around{world, config.repair, seed, check_with_extra_margin, {}};

  const RepairStrategy a_detour{
      "detour", [&](const CheckedPath& best) { return repair::detour(around, best); }};
  std::vector<RepairStrategy> ladder{a_detour};
  if (config.repair.method == repair::Method::humanlike) {
    around.tracking_recovery = {re_solve_mildly(solving),
                                repair::only_if_nearly_free(re_solve_strongly(solving))};
    const RepairStrategy unless_a_dead_end{
        "look for an infeasible frame", [&](const CheckedPath& best) {
          const bool tips_count = config.map.mode != map::MapMode::joint_to_joint;
          if (!tips_count) return repair::StrategyResult{best, {}, false, "skipped (no tip goals)"};
          return stop_if_infeasible(whole, best, check, config.map, seed, holds);
        }};
    const RepairStrategy a_detour_from_the_mapped_path{
        "detour from the mapped path", [&](const CheckedPath& best) {
          return repair::detour_from_mapped(warm_start, around, best);
        }};
    std::vector<RepairStrategy> with_a_detour = around.tracking_recovery;
    with_a_detour.push_back(repair::detour_if_only_collisions(around));
    ladder = {
        re_solve_mildly(solving),
        unless_a_dead_end,
        re_solve_strongly(solving),
        repair::candidate_strategy("paths through collision-free postures",
                                   around.tracking_recovery, check_with_extra_margin,
                                   candidates_through_postures(whole, config.map, holds), ends),
        repair::candidate_strategy("other paths of the mapping", around.tracking_recovery,
                                   check_with_extra_margin,
                                   mapping_candidates(whole, mapped.candidates), ends),
        a_detour,
        a_detour_from_the_mapped_path,
        repair::candidate_strategy(
            "other paths of new mapping searches", std::move(with_a_detour),
            check_with_extra_margin,
            searched_candidates(whole, config.map, config.repair.mapping_searches, seed), ends),
    };
  }
  Outcome<repair::RepairResult> repaired = repair::repair_path(ladder, warm_start);
  if (repaired.failure.reason == Reason::no_path) {
    repaired.failure.detail += "; " + repair::no_path_message(config.repair);
  }
  if (repaired.failure && check(repaired.value.path).empty()) {
    return {{std::move(repaired.value.path), true, {}, std::move(repaired.value.attempts)}, {}};
  }
  return repaired;
}

}  // namespace morphe::planning
