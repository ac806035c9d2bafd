#include "core/solve/trust_region.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace morphe::solve {
namespace {

using Eigen::Index;

struct Step {
  double max_change = 0;           ///< largest entry
  double predicted_reduction = 0;  ///< decrease that the model predicts
};

/// Computes product = (H + damping I) v.
void multiply(const Quadratic& at, double damping, const JointVector& v, JointVector& product) {
  product.noalias() = at.hessian * v;
  product += damping * v;
}

/// Computes Newton's step from x + step in the free variables into `scratch.move`; returns false if
/// the Hessian is not positive definite there.
bool newton_step(double damping, TrustRegionScratch& scratch) {
  if (!scratch.factor.factorise(scratch.now.hessian, damping, scratch.held)) return false;
  scratch.move = -scratch.model_gradient;
  for (Index j = 0; j < scratch.move.size(); ++j) {
    if (scratch.held[j]) scratch.move[j] = 0;
  }
  scratch.factor.solve(scratch.move);
  return true;
}

/// Returns the held variable whose release decreases the model most, -1 if there is no such
/// variable.
Index variable_to_release(const BoundedProblem& problem, const TrustRegionScratch& scratch) {
  Index worst = -1;
  double most = 0;
  for (Index j = 0; j < scratch.x.size(); ++j) {
    if (!scratch.held[j]) continue;
    const bool upper = scratch.x[j] + scratch.step[j] >= problem.upper[j];
    const double inwards = upper ? scratch.model_gradient[j] : -scratch.model_gradient[j];
    if (inwards > most) {
      most = inwards;
      worst = j;
    }
  }
  return worst;
}

/// Adds the move to the step up to the first bound, and holds the variable that reaches it. Returns
/// false if no bound was reached.
bool step_to_bound(const BoundedProblem& problem, double damping, TrustRegionScratch& scratch) {
  double share = 1;
  Index stopped = -1;
  for (Index j = 0; j < scratch.x.size(); ++j) {
    const double from = scratch.x[j] + scratch.step[j], to = from + scratch.move[j];
    const double bound = std::clamp(to, problem.lower[j], problem.upper[j]);
    if (bound == to || scratch.held[j]) continue;
    const double possible = std::max(0.0, (bound - from) / scratch.move[j]);
    if (possible < share) {
      share = possible;
      stopped = j;
    }
  }
  multiply(scratch.now, damping, scratch.move, scratch.hessian_product);
  scratch.step += share * scratch.move;
  scratch.model_gradient += share * scratch.hessian_product;
  if (stopped < 0) return false;
  const bool upper = scratch.move[stopped] > 0;
  scratch.step[stopped] = (upper ? problem.upper : problem.lower)[stopped] - scratch.x[stopped];
  scratch.held[stopped] = 1;
  return true;
}

/// Minimises the model within the bounds into `scratch.step`, from one active set to the next,
/// always decreasing the model. Returns false if the Hessian is not positive definite, or if the
/// step is much too long.
bool minimise_model(const BoundedProblem& problem, double damping, double longest,
                    TrustRegionScratch& scratch) {
  const Index n = scratch.x.size();
  scratch.step.setZero(n);
  scratch.model_gradient = scratch.now.gradient;
  for (Index j = 0; j < n; ++j) {
    const bool outwards = (scratch.x[j] <= problem.lower[j] && scratch.model_gradient[j] > 0) ||
                          (scratch.x[j] >= problem.upper[j] && scratch.model_gradient[j] < 0);
    scratch.held[j] = outwards ? 1 : 0;
  }
  for (Index change = 0; change < 3 * n; ++change) {
    if (!newton_step(damping, scratch)) return false;
    if (scratch.move.cwiseAbs().maxCoeff() > longest) {
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
  // Without a minimum damping, directions of zero curvature would amplify round-off.
  constexpr double kMinDampingRatio = 1e-12, kNoDampingRatio = 1e-6;
  const double largest = scratch.now.hessian.diagonal().cwiseAbs().maxCoeff();
  double damping = kMinDampingRatio * largest;
  // A smaller damping is mostly insufficient: a good part of the last step's damping is needed
  // again.
  if (scratch.damping > kNoDampingRatio * largest)
    damping = std::max(damping, scratch.damping / 30);
  for (int attempt = 0; attempt < 40; ++attempt) {
    scratch.factor.missing_damping = 0;
    if (minimise_model(problem, damping, 1.5 * radius, scratch)) break;
    if (scratch.factor.missing_damping > 0) {
      // The last step's damping indicates the order of magnitude; more than needed would cost
      // steps.
      damping += std::max({3 * damping, 2 * scratch.factor.missing_damping, 0.3 * scratch.damping});
      continue;
    }
    // Assumes that the whole step is along a direction of the model's mean curvature along it.
    multiply(scratch.now, damping, scratch.step, scratch.hessian_product);
    const double damped = scratch.step.dot(scratch.hessian_product) / scratch.step.squaredNorm();
    const double ratio = scratch.step.cwiseAbs().maxCoeff() / radius;
    damping += std::max(damping, (ratio - 1) * damped);
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
  // back on it: up to kMaxUphillSteps steps may increase F before the search returns to the last
  // checkpoint.
  constexpr int kMaxUphillSteps = 3;
  constexpr double kInitialRadius_rad = 0.1, kMaxRadius_rad = 0.5;  // of any variable
  double radius = kInitialRadius_rad;
  Step left;
  int uphill = 0;
  const auto restore_checkpoint = [&] {
    scratch.x.swap(scratch.checkpoint_x);
    std::swap(scratch.now, scratch.checkpoint);
    radius = std::min(radius, left.max_change) / 4;
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
    const bool better =
        uphill > 0 ? scratch.checkpoint.value - scratch.next.value > 1e-4 * left.predicted_reduction
                   : gain > 1e-4 * step.predicted_reduction;
    if (!better && uphill == kMaxUphillSteps) {
      restore_checkpoint();
      continue;
    }
    if (better) {
      uphill = 0;
      if (gain > 0.5 * step.predicted_reduction)
        radius = std::clamp(2 * step.max_change, radius, kMaxRadius_rad);
    } else if (uphill++ == 0) {
      scratch.checkpoint_x = scratch.x;
      std::swap(scratch.checkpoint, scratch.now);
      left = step;
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
