#pragma once

#include <random>
#include <vector>

#include "core/collision/world.hpp"
#include "core/humanlike/frame_objective.hpp"
#include "core/motion/plan.hpp"
#include "core/solve/minimise_movement.hpp"
#include "stages/map/clearance_term.hpp"
#include "stages/map/movement_cost.hpp"

namespace morphe::map {

/// The mapping of one movement: the objectives of all its frames. Robot and world must outlive it.
struct MappingProblem {
  const robot::Robot* robot = nullptr;
  humanlike::FrameObjective objective;               ///< objective of a single frame
  ClearanceTerm clearance;                           ///< added to the objective
  const collision::CollisionWorld* world = nullptr;  ///< for the clearance; of the same robot
  std::vector<double> time;                          ///< [F] demonstration time [s]
  std::vector<humanlike::FrameGoal> goals;           ///< [F]
  /// Returns the number of frames.
  std::size_t frames() const { return time.size(); }
};

/// Buffers of add_frame_objective(), reused from call to call.
struct MappingScratch : humanlike::ObjectiveScratch {
  ClearanceScratch clearance;
  solve::Quadratic model;
};

/// Adds the objective of a frame at q, clearance included, to `model` (already sized n).
void add_frame_objective(const MappingProblem& problem, std::size_t frame, const JointVector& q,
                         MappingScratch& scratch, solve::Quadratic& model,
                         humanlike::Curvature curvature = humanlike::Curvature::gauss_newton);
/// Returns the objective of a frame at q, clearance included; `scratch.model` gets the gradient.
double frame_objective(const MappingProblem& problem, std::size_t frame, const JointVector& q,
                       MappingScratch& scratch);

/// Combines the objectives of all frames and the movement's cost into one problem. Both are scaled
/// by the time that a frame represents, which is longer on a coarser grid. `problem` and `scratch`
/// (filled here) must outlive the result.
solve::MovementProblem make_movement_problem(const MappingProblem& problem,
                                             const MovementCost& cost,
                                             std::vector<MappingScratch>& scratch);

/// Returns a random position inside the joint limits, the same on any machine.
JointVector random_start(const RobotModel& robot, std::mt19937_64& random);

}  // namespace morphe::map
