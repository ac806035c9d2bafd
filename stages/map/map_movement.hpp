#pragma once

#include <cstdint>
#include <vector>

#include "core/motion/outcome.hpp"
#include "stages/map/map_options.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

/// The result of mapping a movement.
struct MapResult {
  MappingResult mapped;               ///< positions, errors and statuses
  JointPath path;                     ///< the mapped positions, all with SampleOrigin::mapped
  std::vector<JointRows> candidates;  ///< other continuous paths for repair, the best first
};

/// Maps the goals of all frames to joint positions (search_movement) and fills goals.reachable.
/// Frames without a goal contribute through smoothness and posture alone. Errors, statuses and
/// reachability refer to `goals`, even if the problem has others (as in joint-to-joint mapping).
/// Fails with Reason::no_goal if no fingertip has a goal or there are fewer than kMinFrames frames.
Outcome<MapResult> map_movement(const MappingProblem& problem, Goals& goals,
                                const MapOptions& options, std::uint64_t seed);

/// Evaluates a path q [F, n] of the movement as if it had been mapped. Fills goals.reachable.
MapResult evaluate_path(const MappingProblem& problem, Goals& goals, const JointRows& q,
                        const MapOptions& options, std::uint64_t seed);

/// Creates the mapping problem of a movement. `robot` and `world` must outlive it.
MappingProblem make_mapping_problem(const robot::Robot& robot, const Goals& goals,
                                    const collision::CollisionWorld& world,
                                    const MapOptions& options,
                                    const std::vector<Phase>& phases = {});

}  // namespace morphe::map
