#pragma once

#include <vector>

#include "core/solve/minimise_movement.hpp"
#include "stages/map/mapping_problem.hpp"
#include "stages/map/movement_cost.hpp"

namespace morphe::map {

/// The problem of a whole movement: the objectives of all frames, the movement's cost, and the
/// motion of the wrist,
///   wrist_motion · sum over frames of ‖p(q_f) - w_f - o‖²,
/// in which p is the origin of the palm's frame, w the human wrist and o an offset that is the same
/// in all frames. It is least if the robot's wrist moves as the human's does, wherever it is: then
/// both have the same speeds. o is optimised too: each frame has three variables o_f more, and a
/// stiff cost of their differences. All is scaled by the time that a frame represents, which is
/// longer on a coarser grid. The term is absent without its weight or for a hand alone.
///
/// `problem` must outlive the movement problem.
struct PathProblem {
  /// Combines the costs; `scratch` holds the buffers of each frame.
  PathProblem(const MappingProblem& problem, const MovementCost& cost);
  PathProblem(const PathProblem&) = delete;
  PathProblem& operator=(const PathProblem&) = delete;

  /// Returns `rows` [F, n] with the offset o as further columns if the problem has them.
  JointRows with_offset(const JointRows& rows, const Vec3& offset) const;
  /// Returns the columns of the joints.
  JointRows joints(const JointRows& variables) const;

  const MappingProblem& mapping;
  solve::MovementProblem movement;
  bool has_offset = false;
  std::vector<MappingScratch> scratch;
};

/// Returns the mean vector from the human wrist to the robot's over a path [F, n], 0 if the wrist
/// was never seen.
Vec3 mean_wrist_offset(const MappingProblem& problem, const JointRows& path);

/// Minimises a movement from a path [F, n]. Returns a path of the joints alone.
solve::MovementMinimum minimise_path(const MappingProblem& problem, const JointRows& start,
                                     const MovementCost& cost,
                                     const solve::MovementOptions& options);

}  // namespace morphe::map
