#include "pipeline/planning/repair_movement.hpp"

#include <utility>
#include <vector>

#include "pipeline/planning/dead_end.hpp"
#include "pipeline/planning/new_courses.hpp"
#include "pipeline/planning/re_solve.hpp"
#include "stages/check/check_path.hpp"
#include "stages/repair/detour.hpp"
#include "stages/repair/other_courses.hpp"

namespace morphe::planning {
namespace {

using repair::Checked;
using repair::Rung;

}  // namespace

collision::CollisionWorld with_room(collision::CollisionWorld world) {
  world.tolerances.margin += 2e-4;
  return world;
}

Outcome<repair::RepairResult> repair_movement(const Planner& planner, const PlacedMovement& placed,
                                              const collision::CollisionWorld& world,
                                              const Plan& plan, const map::MapResult& mapped,
                                              std::uint64_t seed) {
  const PipelineConfig& config = planner.config;
  map::MappingProblem whole = placed.problem;
  whole.world = &world;
  const auto findings_in = [&](const collision::CollisionWorld& of, const JointPath& path) {
    return check::check_path(of, plan.goals, plan.movement, path, config.check);
  };
  const repair::Check check = [&](const JointPath& path) { return findings_in(world, path); };
  const collision::CollisionWorld roomy = with_room(world);
  const repair::Check keeps_room = [&](const JointPath& path) { return findings_in(roomy, path); };

  const Checked start{plan.path, plan.findings};
  const ReSolving solving{whole, config.map, keeps_room};
  std::vector<Hold> holds;  // postures that hold goals at which the path failed
  repair::CourseEnds ends;
  repair::Surroundings around{world, config.repair, seed, keeps_room, {}};

  const Rung a_detour{"detour", [&](const Checked& best) { return repair::detour(around, best); }};
  std::vector<Rung> ladder{a_detour};
  if (config.repair.method == repair::Method::humanlike) {
    around.win_back = {gently(solving), repair::if_nearly_free(firmly(solving))};
    const Rung unless_a_dead_end{
        "look for a dead end", [&](const Checked& best) {
          const bool tips_count = config.map.mode != map::MapMode::joint_to_joint;
          if (!tips_count) return repair::Made{best, {}, false, "not tried: no goals of tips"};
          return stop_at_dead_end(whole, best, check, config.map, seed, holds);
        }};
    const Rung a_detour_from_the_mapped_path{
        "detour from the mapped path",
        [&](const Checked& best) { return repair::detour_from(start, around, best); }};
    std::vector<Rung> with_a_detour = around.win_back;
    with_a_detour.push_back(repair::detour_where_all_collide(around));
    ladder = {
        gently(solving),
        unless_a_dead_end,
        firmly(solving),
        repair::other_courses("courses through free postures", around.win_back, keeps_room,
                              courses_through(whole, config.map, holds), ends),
        repair::other_courses("other courses of the mapping", around.win_back, keeps_room,
                              kept_courses(whole, mapped.candidates), ends),
        a_detour,
        a_detour_from_the_mapped_path,
        repair::other_courses(
            "other courses through the whole scene", std::move(with_a_detour), keeps_room,
            searched_courses(whole, config.map, config.repair.searches, seed), ends),
    };
  }
  Outcome<repair::RepairResult> repaired = repair::repair_path(ladder, start);
  if (repaired.refusal.reason == Reason::no_path) {
    repaired.refusal.detail += "; " + repair::no_free_path(config.repair);
  }
  if (repaired.refusal && check(repaired.value.path).empty()) {
    return {{std::move(repaired.value.path), true, {}, std::move(repaired.value.steps)}, {}};
  }
  return repaired;
}

}  // namespace morphe::planning
