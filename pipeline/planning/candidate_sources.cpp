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
                                                  const std::vector<FeasiblePosture>& postures) {
  return [&, next = std::size_t{0}](bool) mutable -> std::optional<JointPath> {
    if (next == postures.size()) return std::nullopt;
    const FeasiblePosture& posture = postures[next++];
    const map::MappingProblem problem = with_full_scene_clearance(whole);
    return path_of(problem, map::path_through(problem, posture.frame, posture.q, options).q);
  };
}

repair::NextCandidate mapping_candidates(const map::MappingProblem& whole,
                                         const std::vector<JointRows>& kept_paths) {
  return [&, next = std::size_t{0}](bool) mutable -> std::optional<JointPath> {
    if (next == kept_paths.size()) return std::nullopt;
    return path_of(whole, kept_paths[next++]);
  };
}

repair::NextCandidate searched_candidates(const map::MappingProblem& whole,
                                          const map::MapOptions& options, int searches,
                                          std::uint64_t seed) {
  return [&, seed, searches, search_count = 0, search_improved = true, next = std::size_t{0},
          paths = std::vector<map::CandidatePath>()](
             bool improved) mutable -> std::optional<JointPath> {
    search_improved = search_improved || improved;
    const map::MappingProblem problem = with_full_scene_clearance(whole);
    if (next == paths.size()) {
      if (search_count == searches || !search_improved) return std::nullopt;
      search_improved = false;
      const auto number = static_cast<std::size_t>(++search_count);
      paths = map::search_movement(problem, options, math::seed_from(seed, "search", number));
      next = 0;
    }
    return path_of(problem, map::smooth_movement(problem, paths[next++].q, options).q);
  };
}

}  // namespace morphe::planning
