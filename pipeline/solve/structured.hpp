#pragma once

#include "pipeline/solve/envelope_cholesky.hpp"
#include "pipeline/solve/minimise.hpp"

namespace morphe {

/// Memory of descents, to be reused: one a thread.
struct StructuredScratch {
  JointVector x, trial, left_x, step, move, slope, bent;
  std::vector<char> held;
  Quadratic now, next, left;
  EnvelopeCholesky factor;
};

/// Projected Newton in a trust region. Each step minimises the model
///   g·δ + ½ δᵀ (H + μ I) δ  subject to lower <= x + δ <= upper
/// over the variables that are not held: those on a bound that the gradient pushes outwards, and
/// those that the step would carry over theirs, which stop on it. H is the exact Hessian where that
/// is positive definite, else the Gauss–Newton one; μ keeps the step within the region. Stops when
/// the model promises less than relative_value of F.
Minimum minimise_structured(const BoundedProblem& problem, const JointVector& start,
                            const MinimiseOptions& options, StructuredScratch& scratch);

}  // namespace morphe
