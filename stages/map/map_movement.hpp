#pragma once

#include <cstdint>
#include <vector>

#include "core/motion/outcome.hpp"
#include "stages/map/map_options.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

/// The result of mapping a movement.
struct MapResult {
  MappingResult mapped;  ///< positions, errors and statuses
  JointPath path;        ///< the mapped positions, all with SampleOrigin::mapped
  /// Other continuous candidate paths, the best first, for repair.
  std::vector<JointRows> candidates;
  /// Rms deviation from the natural posture while it is active.
  double posture_error_rad = kUnknown;
};

/// Maps the goals of all frames to joint positions, with the movement as one problem
/// (search_movement). Fills goals.reachable. Frames without any goal contribute through smoothness
/// and posture alone. Errors, statuses and reachability refer to `goals`, even if the problem has
/// other goals (as in joint-to-joint mapping). Fails with Reason::no_goal if no fingertip has a
/// goal or the movement has fewer than 5 frames.
Outcome<MapResult> map_movement(const MappingProblem& problem, Goals& goals,
                                const MapOptions& options, std::uint64_t seed);

/// Evaluates any path of the movement as if it had been mapped. Fills goals.reachable.
MapResult evaluate_path(const MappingProblem& problem, Goals& goals, const JointRows& q,
                        const MapOptions& options, std::uint64_t seed);

/// Creates the mapping problem of a movement from the goals of its frames, the weights of their
/// phases, and the collision world.
MappingProblem make_mapping_problem(const robot::Robot& robot, const Goals& goals,
                                    const collision::CollisionWorld& world,
                                    const MapOptions& options,
                                    const std::vector<Phase>& phases = {});

}  // namespace morphe::map
