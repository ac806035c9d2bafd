#pragma once

#include "core/solve/movement_model.hpp"

namespace morphe::solve {

/// [F] How much higher each frame's own value is at `to` than its model at `from` has it at the
/// aimed positions [F, n], from which `to` may be a correction away.
JointVector wrong_by(const MovementPoint& from, const JointRows& aimed, const MovementPoint& to);

/// A step along a curved valley leaves the floor by its square, and a term that it newly meets was
/// in no model. Moves every frame by itself to where its slope is what the step's own model has at
/// the aimed positions, by its model at `to`; directions in which little is curved, and variables
/// on their bounds, stay as they are. Into `corrected` [F, n], perhaps outside the bounds.
void correct(const MovementProblem& problem, const DifferenceCurvature& between,
             const MovementPoint& from, const JointRows& aimed, const MovementPoint& to,
             const JointVector& damping, JointRows& corrected);

}  // namespace morphe::solve
