#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "stages/map/map_options.hpp"
#include "stages/map/mapping_problem.hpp"
#include "stages/repair/repair_strategy.hpp"

namespace morphe::planning {

/// A posture that satisfies a frame's goals within their tolerances and is free of collision.
struct FeasiblePosture {
  std::size_t frame = 0;
  JointVector q;
};

/// A time of a movement for which no feasible posture was found.
struct InfeasibleFrame {
  /// unreachable, with or without obstacles; or goal_in_collision
  Reason reason = Reason::unreachable;
  double time_s = 0;  ///< demonstration time
  int tried = 0;      ///< number of postures that were evaluated
  Finding nearest;    ///< deepest finding of the best of them
};

/// Searches for a feasible posture at the begin, middle and end of each finding, the worst finding
/// first and for at most six frames. The postures are solved with weights of tips and clearance far
/// above all others, from the path and then from the results of a search from random positions.
/// Feasible postures are appended to `holds`. A frame without a feasible posture is returned as
/// infeasible: as far as these starts tell, no path can pass it. Frames at which an object is
/// attached are skipped, because its pose depends on the whole path. `check` returns the findings
/// of a path.
std::optional<InfeasibleFrame> find_infeasible_frame(const map::MappingProblem& problem,
                                                     const repair::CheckedPath& checked,
                                                     const repair::PathCheck& check,
                                                     const map::MapOptions& options,
                                                     std::uint64_t seed,
                                                     std::vector<FeasiblePosture>& holds);

/// The repair strategy that stops with the reason if an infeasible frame is found.
repair::StrategyResult stop_if_infeasible(const map::MappingProblem& problem,
                                          const repair::CheckedPath& best,
                                          const repair::PathCheck& check,
                                          const map::MapOptions& options, std::uint64_t seed,
                                          std::vector<FeasiblePosture>& holds);

}  // namespace morphe::planning
