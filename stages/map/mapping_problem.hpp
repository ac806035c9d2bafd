#pragma once

#include <vector>

#include "core/collision/world.hpp"
#include "core/humanlike/frame_objective.hpp"
#include "core/motion/plan.hpp"
#include "stages/map/clearance_term.hpp"

namespace morphe::map {

/// One movement to be mapped: the objective of its frames in one place. Robot and world must
/// outlive it.
struct MappingProblem {
  const robot::Robot* robot = nullptr;
  humanlike::FrameObjective objective;
  ClearanceTerm clearance;
  const collision::CollisionWorld* world = nullptr;  ///< what the mapping stays clear of
  std::vector<double> time;                          ///< [F] demonstration time [s]
  std::vector<humanlike::FrameGoal> goals;           ///< [F]

  std::size_t frames() const { return time.size(); }
};

struct MappingScratch : humanlike::ObjectiveScratch {
  ClearanceScratch clearance;
  solve::Quadratic model;
};

/// Adds the objective of a frame at q, clearance included, to `model`.
void add_frame(const MappingProblem& problem, std::size_t frame, const JointVector& q,
               MappingScratch& scratch, solve::Quadratic& model,
               humanlike::Curvature curvature = humanlike::Curvature::gauss_newton);

}  // namespace morphe::map
