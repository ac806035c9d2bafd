#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "stages/map/map_options.hpp"
#include "stages/map/mapping_problem.hpp"
#include "stages/repair/repair.hpp"

namespace morphe::planning {

/// A posture that keeps a frame's goals within their tolerances, free of collision.
struct Hold {
  std::size_t frame = 0;
  JointVector q;
};

/// Looks at the beginning, middle and end of each finding, the worst first and not more than six
/// frames, for a posture without findings of its own: solved with tips and clearance far above
/// everything else, from the path and then from `options.starts` random positions. Found ones are
/// appended to `holds`. A frame without any is a dead end: no path can pass it (as far as these
/// starts tell). Frames at which something is carried are not looked at: where it hangs depends on
/// the whole path. `judge` gives the findings of a path.
std::optional<repair::DeadEnd> find_dead_end(
    const map::MappingProblem& problem, const JointPath& path, const std::vector<Finding>& findings,
    const std::function<std::vector<Finding>(const JointPath&)>& judge,
    const map::MapOptions& options, std::uint64_t seed, std::vector<Hold>& holds);

}  // namespace morphe::planning
