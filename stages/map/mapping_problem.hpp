#pragma once

#include <vector>

#include "core/collision/world.hpp"
#include "core/humanlike/frame_objective.hpp"
#include "core/motion/plan.hpp"
#include "stages/map/clearance_term.hpp"

namespace morphe::map {

/// The mapping of one movement: the objectives of all its frames. Robot and world must outlive it.
struct MappingProblem {
  const robot::Robot* robot = nullptr;
  humanlike::FrameObjective objective;  ///< objective of a single frame
  ClearanceTerm clearance;              ///< added to the objective
  /// Collision world from which the mapping keeps clear.
  const collision::CollisionWorld* world = nullptr;
  std::vector<double> time;                 ///< [F] demonstration time [s]
  std::vector<humanlike::FrameGoal> goals;  ///< [F]

  /// Returns the number of frames.
  std::size_t frames() const { return time.size(); }
};

/// Buffers of add_frame_objective(), reused from call to call.
struct MappingScratch : humanlike::ObjectiveScratch {
  ClearanceScratch clearance;
  solve::Quadratic model;
};

/// Adds the objective of a frame at q, clearance included, to `model`.
void add_frame_objective(const MappingProblem& problem, std::size_t frame, const JointVector& q,
                         MappingScratch& scratch, solve::Quadratic& model,
                         humanlike::Curvature curvature = humanlike::Curvature::gauss_newton);

}  // namespace morphe::map
