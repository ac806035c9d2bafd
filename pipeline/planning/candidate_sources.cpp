#include "pipeline/planning/candidate_sources.hpp"

#include <optional>
#include <utility>

#include "core/math/seed.hpp"
#include "pipeline/planning/clearance_weights.hpp"
#include "stages/map/movement_search.hpp"

namespace morphe::planning {
namespace {

map::MappingProblem with_full_scene_clearance(const map::MappingProblem& whole) {
  return with_clearance_weights(whole, {100});
}

std::optional<JointPath> path_of(const map::MappingProblem& problem, JointRows q) {
  return JointPath{std::move(q),
                   std::vector<SampleOrigin>(problem.frames(), SampleOrigin::re_solved),
                   problem.time};
}

}  // namespace

repair::NextCandidate candidates_through_postures(const map::MappingProblem& whole,
                                                  const map::MapOptions& options,
                                                  const std::vector<FeasiblePosture>& holds) {
  return [&, next = std::size_t{0}](bool) mutable -> std::optional<JointPath> {
    if (next == holds.size()) return std::nullopt;
    const FeasiblePosture& hold = holds[next++];
    const map::MappingProblem problem = with_full_scene_clearance(whole);
    return path_of(problem, map::path_through(problem, hold.frame, hold.q, options).q);
  };
}

repair::NextCandidate mapping_candidates(const map::MappingProblem& whole,
                                         const std::vector<JointRows>& courses) {
  return [&, next = std::size_t{0}](bool) mutable -> std::optional<JointPath> {
    if (next == courses.size()) return std::nullopt;
    return path_of(whole, courses[next++]);
  };
}

repair::NextCandidate searched_candidates(const map::MappingProblem& whole,
                                          const map::MapOptions& options, int searches,
                                          std::uint64_t seed) {
  return [&, seed, searches, searched = 0, came_nearer = true, next = std::size_t{0},
          courses =
              std::vector<map::CandidatePath>()](bool nearer) mutable -> std::optional<JointPath> {
    came_nearer = came_nearer || nearer;
    const map::MappingProblem problem = with_full_scene_clearance(whole);
    if (next == courses.size()) {
      if (searched == searches || !came_nearer) return std::nullopt;
      came_nearer = false;
      const auto number = static_cast<std::size_t>(++searched);
      courses = map::search_movement(problem, options, math::seed_from(seed, "search", number));
      next = 0;
    }
    return path_of(problem, map::smooth_movement(problem, courses[next++].q, options).q);
  };
}

}  // namespace morphe::planning
