#pragma once

#include "core/solve/movement_model.hpp"

namespace morphe::solve {

/// Returns [F] each frame's own value at `end`, less the value that its model at `begin` predicts
/// at the aimed positions [F, n], from which `end` may differ by a correction.
JointVector model_error(const MovementPoint& begin, const JointRows& aimed,
                        const MovementPoint& end);

/// Corrects a step. Along a curved valley a step leaves the bottom by a second-order distance, and
/// terms that become active only now were in no model. Moves every frame separately to the position
/// at which its gradient, by its model at `end`, equals the gradient that its model at `begin` has
/// at the aimed positions; directions of low curvature hardly change, variables on bounds not at
/// all. The result `corrected` [F, n] may be outside the bounds.
void correct_step(const MovementProblem& problem, const DifferenceCurvature& between,
                  const MovementPoint& begin, const JointRows& aimed, const MovementPoint& end,
                  const JointVector& damping, JointRows& corrected);

}  // namespace morphe::solve
