#pragma once

#include "core/solve/band_cholesky.hpp"
#include "core/solve/movement_model.hpp"

namespace morphe::solve {

/// Computes the step [F, n] from a point that minimises the damped model within the bounds (a
/// primal-dual active set method, up to a few changes of the active set) and does not exceed the
/// range of validity of the models: frames with longer steps get more damping [F], which is kept. A
/// model without a minimum is permanently made convex. Returns false if the damping is insufficient
/// even then. `hessian` is scratch of the problem's size.
bool damped_step(const MovementProblem& problem, const DifferenceCurvature& between,
                 MovementPoint& now, JointVector& damping, BandCholesky& hessian, JointRows& step);

}  // namespace morphe::solve
