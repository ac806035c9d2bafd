#pragma once

#include <cstdint>
#include <vector>

#include "core/motion/outcome.hpp"
#include "stages/map/map_options.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

struct MapResult {
  Mapped mapped;
  JointPath path;                       ///< the mapped positions, all Origin::mapped
  std::vector<JointRows> candidates;    ///< other continuous courses, the best first, for repair
  double posture_error_rad = kNotSeen;  ///< rms from the natural posture where it is asked for
};

/// Frames to joint angles, the movement as one problem (search_movement). Fills goals.reachable.
/// Frames without any goal take part through smoothness and posture alone. Whatever the problem's
/// own goals are (joint-to-joint has others), errors, statuses and reach are those of `goals`.
/// Refused: no_goal.
Outcome<MapResult> map_movement(const MappingProblem& problem, Goals& goals,
                                const MapOptions& options, std::uint64_t seed);

/// Any path of the movement, measured and judged as if it had been mapped; fills goals.reachable.
MapResult judge_path(const MappingProblem& problem, Goals& goals, const JointRows& q,
                     const MapOptions& options, std::uint64_t seed);

/// The problem of a movement: goals frame by frame, with the weights of their phases, and the world
/// to stay clear of.
MappingProblem make_mapping_problem(const robot::Robot& robot, const Goals& goals,
                                    const collision::CollisionWorld& world,
                                    const MapOptions& options,
                                    const std::vector<Phase>& phases = {});

}  // namespace morphe::map
