#pragma once

#include "core/solve/envelope_cholesky.hpp"
#include "core/solve/minimise.hpp"

namespace morphe::solve {

/// Memory of descents, to be reused: one a thread.
struct StructuredScratch {
  JointVector x, trial, left_x, step, move, slope, bent;
  std::vector<char> held;
  Quadratic now, next, left;
  EnvelopeCholesky factor;
  double damping = 0;  ///< of the last step
};

/// Newton in a trust region. Each step minimises the model
///   g·δ + ½ δᵀ (H + μ I) δ  subject to lower <= x + δ <= upper
/// by active sets. H is the exact Hessian; μ makes it positive definite and keeps
/// the step within the region. A step may go uphill for a while: a curved valley's floor is left
/// and met again. Stops when the model promises less than relative_value of F.
Minimum minimise_structured(const BoundedProblem& problem, const JointVector& start,
                            const MinimiseOptions& options, StructuredScratch& scratch);

}  // namespace morphe::solve
