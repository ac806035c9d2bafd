#include "core/solve/trust_region.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/solve/constants.hpp"

namespace morphe::solve {
namespace {

using Eigen::Index;

struct Step {
  double max_change = 0;  ///< of a variable
  double predicted_reduction = 0;
};

/// Computes product = (H + damping I) v.
void multiply(const Quadratic& model, double damping, const JointVector& v, JointVector& product) {
  product.noalias() = model.hessian * v;
  product += damping * v;
}

/// Computes Newton's step of the free variables into `scratch.move` if H is positive definite.
bool newton_step(double damping, TrustRegionScratch& scratch) {
  if (!scratch.factor.factorise(scratch.now.hessian, damping, scratch.held)) return false;
  scratch.move = -scratch.model_gradient;
  for (Index j = 0; j < scratch.move.size(); ++j)
    if (scratch.held[j]) scratch.move[j] = 0;
  scratch.factor.solve(scratch.move);
  return true;
}

/// Returns the held variable whose release decreases the model fastest, or -1.
Index variable_to_release(const BoundedProblem& problem, const TrustRegionScratch& scratch) {
  Index released = -1;
  double max_slope = 0;
  for (Index j = 0; j < scratch.x.size(); ++j) {
    if (!scratch.held[j]) continue;
    const bool upper = scratch.x[j] + scratch.step[j] >= problem.upper[j];
    const double slope = upper ? scratch.model_gradient[j] : -scratch.model_gradient[j];
    if (slope > max_slope) {
      max_slope = slope;
      released = j;
    }
  }
  return released;
}

/// Adds the move up to the first bound; returns true if a variable reached it, which is now held.
bool step_to_bound(const BoundedProblem& problem, double damping, TrustRegionScratch& scratch) {
  double fraction = 1;
  Index stopped = -1;
  for (Index j = 0; j < scratch.x.size(); ++j) {
    const double begin = scratch.x[j] + scratch.step[j], end = begin + scratch.move[j];
    const double bound = std::clamp(end, problem.lower[j], problem.upper[j]);
    if (bound == end || scratch.held[j]) continue;
    const double possible = std::max(0.0, (bound - begin) / scratch.move[j]);
    if (possible < fraction) {
      fraction = possible;
      stopped = j;
    }
  }
  multiply(scratch.now, damping, scratch.move, scratch.hessian_product);
  scratch.step += fraction * scratch.move;
  scratch.model_gradient += fraction * scratch.hessian_product;
  if (stopped < 0) return false;
  const bool upper = scratch.move[stopped] > 0;
  scratch.step[stopped] = (upper ? problem.upper : problem.lower)[stopped] - scratch.x[stopped];
  scratch.held[stopped] = 1;
  return true;
}

/// Minimises the model within the bounds into `scratch.step`, from active set to active set, always
/// decreasing it. Returns false if H is not positive definite or a move is above max_change.
bool minimise_model(const BoundedProblem& problem, double damping, double max_change,
                    TrustRegionScratch& scratch) {
  const Index n = scratch.x.size();
  scratch.step.setZero(n);
  scratch.model_gradient = scratch.now.gradient;
  for (Index j = 0; j < n; ++j) {
    const bool outwards = (scratch.x[j] <= problem.lower[j] && scratch.model_gradient[j] > 0) ||
                          (scratch.x[j] >= problem.upper[j] && scratch.model_gradient[j] < 0);
    scratch.held[j] = outwards ? 1 : 0;
  }
  for (Index change = 0; change < kActiveSetChangesPerVariable * n; ++change) {
    if (!newton_step(damping, scratch)) return false;
    if (scratch.move.cwiseAbs().maxCoeff() > max_change) {
      scratch.step += scratch.move;
      return false;
    }
    if (step_to_bound(problem, damping, scratch)) continue;
    const Index freed = variable_to_release(problem, scratch);
    if (freed < 0) break;
    scratch.held[freed] = 0;
  }
  return true;
}

/// Computes the step within the bounds, damped until its entries are near or below the radius.
Step trust_region_step(const BoundedProblem& problem, double radius, TrustRegionScratch& scratch) {
  const double max_curvature = scratch.now.hessian.diagonal().cwiseAbs().maxCoeff();
  double damping = kMinDampingRatio * max_curvature;
  // A good part of the last step's damping is mostly needed again.
  if (scratch.damping > kNoDampingRatio * max_curvature)
    damping = std::max(damping, scratch.damping / kLastDampingDivisor);
  for (int attempt = 0; attempt < kMaxDampings; ++attempt) {
    scratch.factor.missing_damping = 0;
    if (minimise_model(problem, damping, kRadiusExcessFactor * radius, scratch)) break;
    if (scratch.factor.missing_damping > 0) {
      // The last step's damping tells the magnitude; more than needed would cost steps.
      damping += std::max({kDampingGrowth * damping,
                           kMissingDampingFactor * scratch.factor.missing_damping,
                           kLastDampingShare * scratch.damping});
      continue;
    }
    // Assumes that the whole step is along a direction of the model's mean curvature along it.
    multiply(scratch.now, damping, scratch.step, scratch.hessian_product);
    const double curvature = scratch.step.dot(scratch.hessian_product) / scratch.step.squaredNorm();
    const double ratio = scratch.step.cwiseAbs().maxCoeff() / radius;
    damping += std::max(damping, (ratio - 1) * curvature);
  }
  scratch.damping = damping;
  multiply(scratch.now, 0, scratch.step, scratch.hessian_product);
  return {scratch.step.cwiseAbs().maxCoeff(),
          -scratch.step.dot(scratch.now.gradient + 0.5 * scratch.hessian_product)};
}

}  // namespace

Minimum minimise_trust_region(const BoundedProblem& problem, const JointVector& start,
                              const MinimiseOptions& options, TrustRegionScratch& scratch) {
  assert(problem.model);
  const Index n = start.size();
  scratch.damping = 0;
  scratch.held.resize(n);
  scratch.x = start.cwiseMax(problem.lower).cwiseMin(problem.upper);
  Minimum result;
  const auto evaluate = [&](const JointVector& x, Quadratic& model) {
    model.reset(n);
    problem.model(x, model);
    ++result.evaluations;
  };
  evaluate(scratch.x, scratch.now);

  // Along a curved valley, a good step leaves the bottom and only pays off when the next ones are
  // back on it, so some steps may increase F before the search returns to the last checkpoint.
  double radius = kInitialRadius_rad;
  Step checkpoint_step;
  int uphill = 0;
  const auto restore_checkpoint = [&] {
    scratch.x.swap(scratch.checkpoint_x);
    std::swap(scratch.now, scratch.checkpoint);
    radius = std::min(radius, checkpoint_step.max_change) / kRadiusFallFactor;
    uphill = 0;
  };
  while (result.evaluations < options.max_evaluations) {
    const Step step = trust_region_step(problem, radius, scratch);
    if (step.predicted_reduction <= options.relative_tolerance * std::abs(scratch.now.value) ||
        step.max_change <= options.step_tolerance_rad) {
      if (uphill > 0) {
        restore_checkpoint();
        continue;
      }
      result.converged = true;
      break;
    }
    scratch.trial = (scratch.x + scratch.step).cwiseMax(problem.lower).cwiseMin(problem.upper);
    for (Index j = 0; j < n; ++j) {  // held variables are exactly on their bound
      if (!scratch.held[j]) continue;
      const double middle = 0.5 * (problem.lower[j] + problem.upper[j]);
      scratch.trial[j] = (scratch.trial[j] > middle ? problem.upper : problem.lower)[j];
    }
    evaluate(scratch.trial, scratch.next);
    const double gain = scratch.now.value - scratch.next.value;
    const Step& judged = uphill > 0 ? checkpoint_step : step;
    const double total_gain = uphill > 0 ? scratch.checkpoint.value - scratch.next.value : gain;
    const bool better = total_gain > kMinDecreaseShare * judged.predicted_reduction;
    if (!better && uphill == kMaxUphillSteps) {
      restore_checkpoint();
      continue;
    }
    if (better) {
      uphill = 0;
      if (gain > kWideningDecreaseShare * step.predicted_reduction)
        radius = std::clamp(kRadiusRiseFactor * step.max_change, radius, kMaxRadius_rad);
    } else if (uphill++ == 0) {
      scratch.checkpoint_x = scratch.x;
      std::swap(scratch.checkpoint, scratch.now);
      checkpoint_step = step;
    }
    scratch.x.swap(scratch.trial);
    std::swap(scratch.now, scratch.next);
  }
  if (uphill > 0) restore_checkpoint();
  result.x = scratch.x;
  result.value = scratch.now.value;
  return result;
}

}  // namespace morphe::solve
