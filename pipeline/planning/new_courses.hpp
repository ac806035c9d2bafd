#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/planning/dead_end.hpp"
#include "stages/map/map_options.hpp"
#include "stages/map/mapping_problem.hpp"
#include "stages/repair/other_courses.hpp"

namespace morphe::planning {

// Where other courses through a movement come from, the best of each kind first. `whole` is the
// movement against the whole scene; what is given by reference must outlive what is returned.

/// Those that go through postures which hold goals at which the path failed.
repair::NextCourse courses_through(const map::MappingProblem& whole, const map::MapOptions& options,
                                   const std::vector<Hold>& holds);

/// Those that the mapping kept.
repair::NextCourse kept_courses(const map::MappingProblem& whole,
                                const std::vector<JointRows>& courses);

/// Those of new searches with the whole scene in sight. A search waits until its first course is
/// asked for, and is the last if no course of it came nearer.
repair::NextCourse searched_courses(const map::MappingProblem& whole,
                                    const map::MapOptions& options, int searches,
                                    std::uint64_t seed);

}  // namespace morphe::planning
