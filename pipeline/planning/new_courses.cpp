#include "pipeline/planning/new_courses.hpp"

#include <optional>
#include <utility>

#include "core/math/seed.hpp"
#include "pipeline/planning/firmness.hpp"
#include "stages/map/movement_search.hpp"

namespace morphe::planning {
namespace {

map::MappingProblem in_sight_of_all(const map::MappingProblem& whole) {
  return as_firm(whole, {100});
}

std::optional<JointPath> path_of(const map::MappingProblem& problem, JointRows q) {
  return JointPath{std::move(q), std::vector<Origin>(problem.frames(), Origin::resolved),
                   problem.time};
}

}  // namespace

repair::NextCourse courses_through(const map::MappingProblem& whole, const map::MapOptions& options,
                                   const std::vector<Hold>& holds) {
  return [&, next = std::size_t{0}](bool) mutable -> std::optional<JointPath> {
    if (next == holds.size()) return std::nullopt;
    const Hold& hold = holds[next++];
    const map::MappingProblem problem = in_sight_of_all(whole);
    return path_of(problem, map::course_through(problem, hold.frame, hold.q, options).q);
  };
}

repair::NextCourse kept_courses(const map::MappingProblem& whole,
                                const std::vector<JointRows>& courses) {
  return [&, next = std::size_t{0}](bool) mutable -> std::optional<JointPath> {
    if (next == courses.size()) return std::nullopt;
    return path_of(whole, courses[next++]);
  };
}

repair::NextCourse searched_courses(const map::MappingProblem& whole,
                                    const map::MapOptions& options, int searches,
                                    std::uint64_t seed) {
  return [&, seed, searches, searched = 0, came_nearer = true, next = std::size_t{0},
          courses = std::vector<map::Course>()](bool nearer) mutable -> std::optional<JointPath> {
    came_nearer = came_nearer || nearer;
    const map::MappingProblem problem = in_sight_of_all(whole);
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
