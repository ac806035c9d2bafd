#pragma once

#include "pipeline/solve/envelope_cholesky.hpp"
#include "pipeline/solve/minimise.hpp"

namespace morphe {

struct StructuredScratch {
  JointVector x, trial, step, right_side, damping;
  std::vector<char> held;
  Quadratic now, next;
  EnvelopeCholesky factor;
};

/// Projected Newton with Levenberg–Marquardt damping. Each step minimises the model
///   g·δ + ½ δᵀ (H + μ D) δ  subject to lower <= x + δ <= upper
/// over the variables that are not held: those on a bound that the gradient pushes outwards, and
/// those that the step would carry over theirs, which stop on it. A step is taken only if it gains.
/// Stops when the model promises less than relative_value of F.
Minimum minimise_structured(const BoundedProblem& problem, const JointVector& start,
                            const MinimiseOptions& options, StructuredScratch& scratch);

}  // namespace morphe
