#pragma once

#include "core/solve/bounded_problem.hpp"
#include "core/solve/envelope_cholesky.hpp"

namespace morphe::solve {

/// Buffers of minimise_trust_region(), to be reused; one for each thread.
struct TrustRegionScratch {
  JointVector x, trial, checkpoint_x, step, move, model_gradient, hessian_product;
  std::vector<char> held;
  Quadratic now, next, checkpoint;
  EnvelopeCholesky factor;
  double damping = 0;  ///< of the last step
};

/// Minimises by Newton's method in a trust region. Each step minimises the model
///   g·δ + ½ δᵀ (H + μ I) δ  subject to lower <= x + δ <= upper
/// by an active set method. H is the exact Hessian; μ makes H + μ I positive definite and keeps the
/// step within the trust region. A few consecutive steps may increase F, because the bottom of a
/// curved valley is left and reached again. It stops by the tolerances on the predicted decrease
/// and on the step, or after max_evaluations.
Minimum minimise_trust_region(const BoundedProblem& problem, const JointVector& start,
                              const MinimiseOptions& options, TrustRegionScratch& scratch);

}  // namespace morphe::solve
