#pragma once

#include "core/solve/bounded_problem.hpp"

namespace morphe::solve {

/// Finds a local minimum from a start point, which is clamped to the bounds. Deterministic.
Minimum minimise(const BoundedProblem& problem, const JointVector& start,
                 const MinimiseOptions& options);

}  // namespace morphe::solve
