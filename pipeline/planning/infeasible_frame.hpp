#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "stages/map/map_options.hpp"
#include "stages/map/mapping_problem.hpp"
#include "stages/repair/repair_strategy.hpp"

namespace morphe::planning {

/// A posture without findings in a frame: it meets the goals and does not collide.
struct FeasiblePosture {
  std::size_t frame = 0;
  JointVector q;
};

/// A time of a movement for which no feasible posture was found.
struct InfeasibleFrame {
  /// goal_in_collision if a posture meets the goals when obstacles are ignored, else unreachable
  Reason reason = Reason::unreachable;
  double time_s = 0;      ///< demonstration time
  int posture_count = 0;  ///< number of postures that were evaluated
  /// The worst collision of the best posture that meets the goals, or for `unreachable` the largest
  /// tip error of the posture that comes nearest to the goals.
  Finding worst_finding;
  /// The largest tip error of the best posture that does not collide; empty for `unreachable`, and
  /// if every posture collides.
  std::optional<Finding> tip_error_if_clear;
};

/// Searches for feasible postures at the middle, begin and end of each finding of a path, the worst
/// finding first, in at most kMaxFramesPerPath frames. The postures are solved with weights of tips
/// and clearance far above all others, from the path and then from the results of a search from
/// random positions. They are appended to `postures`. Returns the first frame without a feasible
/// posture, which as far as these starts tell no path can pass; nullopt if there is no such frame.
/// A frame that is feasible but for kNearlyFeasibleDepth_m is passed over. So are frames in which
/// the target is attached, because its pose depends on the whole path. `check` returns the findings
/// of a path.
std::optional<InfeasibleFrame> find_infeasible_frame(const map::MappingProblem& problem,
                                                     const repair::CheckedPath& checked,
                                                     const repair::PathCheck& check,
                                                     const map::MapOptions& options,
                                                     std::uint64_t seed,
                                                     std::vector<FeasiblePosture>& postures);

/// Returns why no path can pass the frame, with its finding, in a sentence that agrees with the
/// reason.
std::string detail_of(const InfeasibleFrame& frame);

/// Returns `best`; as a failure that no strategy can mend if find_infeasible_frame() finds one.
repair::StrategyResult stop_if_infeasible(const map::MappingProblem& problem,
                                          const repair::CheckedPath& best,
                                          const repair::PathCheck& check,
                                          const map::MapOptions& options, std::uint64_t seed,
                                          std::vector<FeasiblePosture>& postures);

}  // namespace morphe::planning
