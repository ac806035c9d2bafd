#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "stages/map/map_options.hpp"
#include "stages/map/mapping_problem.hpp"
#include "stages/repair/ladder.hpp"

namespace morphe::planning {

/// A posture that keeps a frame's goals within their tolerances, free of collision.
struct Hold {
  std::size_t frame = 0;
  JointVector q;
};

/// A time of a movement for which no posture is good enough.
struct DeadEnd {
  Reason reason = Reason::unreachable;  ///< obstacles or not; or goal_in_collision
  double time_s = 0;                    ///< demonstration time
  int tried = 0;                        ///< postures that were looked at
  Finding nearest;                      ///< what is wrong with the best of them
};

/// Looks at the beginning, middle and end of each finding, the worst first and not more than six
/// frames, for a posture without findings of its own: solved with tips and clearance far above
/// everything else, from the path and then from `options.starts` random positions. Found ones are
/// appended to `holds`. A frame without any is a dead end: no path can pass it (as far as these
/// starts tell). Frames at which something is carried are not looked at: where it hangs depends on
/// the whole path. `check` gives the findings of a path.
std::optional<DeadEnd> find_dead_end(const map::MappingProblem& problem,
                                     const repair::Checked& checked, const repair::Check& check,
                                     const map::MapOptions& options, std::uint64_t seed,
                                     std::vector<Hold>& holds);

/// The rung that gives up where a dead end is found, with its reason.
repair::Made stop_at_dead_end(const map::MappingProblem& problem, const repair::Checked& best,
                              const repair::Check& check, const map::MapOptions& options,
                              std::uint64_t seed, std::vector<Hold>& holds);

}  // namespace morphe::planning
