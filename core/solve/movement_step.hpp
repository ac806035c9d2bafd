#pragma once

#include "core/solve/band_cholesky.hpp"
#include "core/solve/movement_model.hpp"

namespace morphe::solve {

/// The step [F, n] from a point that minimises the damped model within the bounds (a primal-dual
/// active set method, as far as a few changes of the held variables bring it), and no longer than
/// models hold: frames whose step is get more of the damping [F], which stays with them. A model
/// without a minimum is made convex, for good. False if the damping does not suffice for that
/// either. `hessian` is scratch of the problem's size.
bool short_step(const MovementProblem& problem, const DifferenceCurvature& between,
                MovementPoint& now, JointVector& damping, BandCholesky& hessian, JointRows& step);

}  // namespace morphe::solve
