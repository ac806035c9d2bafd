#pragma once

#include <vector>

#include "core/solve/minimise_movement.hpp"
#include "stages/map/mapping_problem.hpp"
#include "stages/map/movement_cost.hpp"

namespace morphe::map {

/// The problem of a whole movement: the objectives of all frames, the movement's cost, and the
/// motion of the wrist,
///   wrist_motion · sum over frames of ‖(u_f+1 - u_f) / h‖²,  u_f = p(q_f) - w_f,
/// in which p is the robot's wrist (arm_wrist()), w the human wrist and h the time between frames.
/// It is least if both wrists have the same velocity, wherever they are. The solver couples frames
/// by differences of variables alone: each frame has three variables o_f more, which follow u_f
/// (kWristFollowing_per_m2), and the differences are theirs. All is scaled by the time that a frame
/// represents, which is longer on a coarser grid. The term is absent without its weight or for a
/// hand alone.
///
/// `problem` must outlive the movement problem.
struct PathProblem {
  /// Combines the costs; `scratch` holds the buffers of each frame.
  PathProblem(const MappingProblem& problem, const MovementCost& cost);
  PathProblem(const PathProblem&) = delete;
  PathProblem& operator=(const PathProblem&) = delete;

  /// Returns a path [F, n] with `offsets` [F, 3] as further columns if the problem has them.
  JointRows with_offsets(const JointRows& path, const JointRows& offsets) const;
  /// Returns the columns of the joints.
  JointRows joints(const JointRows& variables) const;

  const MappingProblem& mapping;
  solve::MovementProblem movement;
  bool has_offsets = false;
  std::vector<MappingScratch> scratch;
};

/// Returns u_f of a path [F, n]: the vectors [F, 3] from the human wrist to the robot's, in a frame
/// without a wrist that of the frame before, or else of the first with one; 0 if there is none.
JointRows wrist_offsets(const MappingProblem& problem, const JointRows& path);

/// Minimises a movement from a path [F, n]. Returns a path of the joints alone.
solve::MovementMinimum minimise_path(const MappingProblem& problem, const JointRows& start,
                                     const MovementCost& cost,
                                     const solve::MovementOptions& options);

}  // namespace morphe::map
