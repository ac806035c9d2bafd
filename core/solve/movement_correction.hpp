#pragma once

#include "core/solve/movement_model.hpp"

namespace morphe::solve {

/// Returns [F] the difference between each frame's own value at `to` and the value that its model
/// at `from` predicts at the aimed positions [F, n], from which `to` may differ by a correction.
JointVector model_error(const MovementPoint& from, const JointRows& aimed, const MovementPoint& to);

/// Corrects a step. Along a curved valley a step leaves the bottom by a second-order distance, and
/// terms that become active only now were in no model. Moves every frame separately to the position
/// at which its gradient, by its model at `to`, equals the gradient that the step's own model has
/// at the aimed positions; directions of low curvature and variables on their bounds do not change.
/// The result `corrected` [F, n] may be outside the bounds.
void correct_step(const MovementProblem& problem, const DifferenceCurvature& between,
                  const MovementPoint& from, const JointRows& aimed, const MovementPoint& to,
                  const JointVector& damping, JointRows& corrected);

}  // namespace morphe::solve
