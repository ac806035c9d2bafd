#include "pipeline/solve/structured.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace morphe {
namespace {

using Eigen::Index;

/// The step of the damped model inside the bounds into `scratch.step`; false if the damped Hessian
/// is not positive definite on the free variables.
bool bounded_step(const BoundedProblem& problem, double damping, StructuredScratch& scratch) {
  const JointVector& x = scratch.x;
  const Quadratic& model = scratch.now;
  const Index n = x.size();
  const double largest = model.hessian.diagonal().cwiseAbs().maxCoeff();
  scratch.damping = damping * (model.hessian.diagonal().cwiseAbs().array() + 1e-3 * largest);
  scratch.step.setZero(n);
  bool any_moved = false;
  for (Index j = 0; j < n; ++j) {
    const bool outwards = (x[j] <= problem.lower[j] && model.gradient[j] > 0) ||
                          (x[j] >= problem.upper[j] && model.gradient[j] < 0);
    scratch.held[static_cast<std::size_t>(j)] = outwards ? 1 : 0;
  }
  for (bool again = true; again;) {
    again = false;
    if (!scratch.factor.factorise(model.hessian, scratch.damping, scratch.held)) return false;
    scratch.right_side = -model.gradient;
    if (any_moved) {  // variables that stop on their bounds pull at the others
      for (Index j = 0; j < n; ++j) {
        const auto held = static_cast<std::size_t>(j);
        if (scratch.held[held] && scratch.step[j] != 0) {
          scratch.right_side.noalias() -= scratch.step[j] * model.hessian.col(j);
        }
      }
    }
    for (Index j = 0; j < n; ++j) {
      if (scratch.held[static_cast<std::size_t>(j)]) scratch.right_side[j] = scratch.step[j];
    }
    scratch.factor.solve(scratch.right_side);
    for (Index j = 0; j < n; ++j) {
      if (scratch.held[static_cast<std::size_t>(j)]) continue;
      const double to = x[j] + scratch.right_side[j];
      const double bound = std::clamp(to, problem.lower[j], problem.upper[j]);
      if (bound == to) continue;
      scratch.held[static_cast<std::size_t>(j)] = 1;
      scratch.step[j] = bound - x[j];
      again = any_moved = true;
    }
  }
  scratch.step.swap(scratch.right_side);
  return true;
}

}  // namespace

Minimum minimise_structured(const BoundedProblem& problem, const JointVector& start,
                            const MinimiseOptions& options, StructuredScratch& scratch) {
  assert(problem.model);
  const Index n = start.size();
  scratch.held.resize(static_cast<std::size_t>(n));
  scratch.x = start.cwiseMax(problem.lower).cwiseMin(problem.upper);
  Minimum result;
  const auto evaluate = [&](const JointVector& x, Quadratic& model) {
    model.reset(n);
    problem.model(x, model);
    ++result.evaluations;
  };
  evaluate(scratch.x, scratch.now);

  double damping = 0;
  constexpr double kLeastDamping = 1e-6, kMostDamping = 1e8;
  const auto damp_more = [&](double factor) {
    damping = std::max(damping * factor, kLeastDamping);
    return damping <= kMostDamping;
  };
  while (result.evaluations < options.evaluations) {
    if (!bounded_step(problem, damping, scratch)) {
      if (damp_more(10)) continue;
      break;
    }
    const JointVector& step = scratch.step;
    scratch.right_side.noalias() = scratch.now.hessian * step;
    const double promised = -scratch.now.gradient.dot(step) - 0.5 * step.dot(scratch.right_side);
    if (promised < 0 && damp_more(10)) continue;  // the bounds stopped it where H curves down
    if (promised <= options.relative_value * std::abs(scratch.now.value) ||
        step.cwiseAbs().maxCoeff() <= options.absolute_step_rad) {
      result.converged = true;
      break;
    }
    scratch.trial = (scratch.x + step).cwiseMax(problem.lower).cwiseMin(problem.upper);
    evaluate(scratch.trial, scratch.next);
    const double gain = scratch.now.value - scratch.next.value;
    if (!(gain > 1e-4 * promised)) {
      if (damp_more(8)) continue;
      break;
    }
    scratch.x.swap(scratch.trial);
    std::swap(scratch.now, scratch.next);
    if (gain > 0.75 * promised) {
      damping = damping > kLeastDamping ? damping / 8 : 0;
    } else if (gain < 0.25 * promised) {
      damp_more(4);
    }
  }
  result.x = scratch.x;
  result.value = scratch.now.value;
  return result;
}

}  // namespace morphe
