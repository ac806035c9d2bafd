#pragma once

#include <vector>

#include "pipeline/collision/world.hpp"
#include "pipeline/humanlike/frame_objective.hpp"
#include "pipeline/motion/plan.hpp"
#include "stages/map/clearance_term.hpp"

namespace morphe {

/// One movement to be mapped: the objective of its frames in one place. Robot and world must
/// outlive it.
struct MappingProblem {
  const RobotTable* robot = nullptr;
  FrameObjective objective;
  ClearanceTerm clearance;
  const CollisionWorld* world = nullptr;  ///< what the mapping stays clear of
  std::vector<double> time;               ///< [F] demonstration time [s]
  std::vector<FrameGoal> goals;           ///< [F]

  std::size_t frames() const { return time.size(); }
};

struct MappingScratch : ObjectiveScratch {
  ClearanceScratch clearance;
  Quadratic model;
};

/// Adds the objective of a frame at q, clearance included, to `model`.
void add_frame(const MappingProblem& problem, std::size_t frame, const JointVector& q,
               MappingScratch& scratch, Quadratic& model,
               Curvature curvature = Curvature::gauss_newton);

}  // namespace morphe
