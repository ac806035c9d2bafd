#include "pipeline/solve/structured.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace morphe {
namespace {

using Eigen::Index;

/// The descent's present model, with or without what makes its Hessian exact.
struct Model {
  const Quadratic& at;
  bool exact;
  double damping;

  /// right_side -= H column * factor.
  void subtract_column(Index column, double factor, JointVector& right_side) const {
    right_side.noalias() -= factor * at.hessian.col(column);
    if (exact) right_side.noalias() -= factor * at.bend.col(column);
  }
  /// δᵀ H δ without damping.
  double curved(const JointVector& step) const {
    double sum = 0;
    for (Index j = 0; j < step.size(); ++j) {
      if (step[j] == 0) continue;
      sum += step[j] * at.hessian.col(j).dot(step);
      if (exact) sum += step[j] * at.bend.col(j).dot(step);
    }
    return sum;
  }
};

/// The step over the variables that are not held, the others' given by `scratch.step`, into
/// `scratch.right_side`; false if the Hessian is not positive definite on the free variables.
bool free_step(const Model& model, bool any_stopped, StructuredScratch& scratch) {
  const Index n = scratch.x.size();
  if (!scratch.factor.factorise(model.at, model.exact, model.damping, scratch.held)) return false;
  scratch.right_side = -model.at.gradient;
  for (Index j = 0; any_stopped && j < n; ++j) {  // they pull at the others
    if (scratch.step[j] != 0) model.subtract_column(j, scratch.step[j], scratch.right_side);
  }
  for (Index j = 0; j < n; ++j) {
    if (scratch.held[static_cast<std::size_t>(j)]) scratch.right_side[j] = scratch.step[j];
  }
  scratch.factor.solve(scratch.right_side);
  return true;
}

/// Holds the variables whose step leads over their bounds, there; false if there were none.
bool stop_at_bounds(const BoundedProblem& problem, StructuredScratch& scratch) {
  bool any = false;
  for (Index j = 0; j < scratch.x.size(); ++j) {
    if (scratch.held[static_cast<std::size_t>(j)]) continue;
    const double to = scratch.x[j] + scratch.right_side[j];
    const double bound = std::clamp(to, problem.lower[j], problem.upper[j]);
    if (bound == to) continue;
    scratch.held[static_cast<std::size_t>(j)] = 1;
    scratch.step[j] = bound - scratch.x[j];
    any = true;
  }
  return any;
}

struct Step {
  double longest = 0;   ///< largest entry
  double promised = 0;  ///< what the model gains by it
};

/// The model's step inside the bounds into `scratch.step`, damped until its entries are near or
/// below the radius.
Step bounded_step(const BoundedProblem& problem, double radius, StructuredScratch& scratch) {
  const JointVector& x = scratch.x;
  const JointVector& gradient = scratch.now.gradient;
  const Index n = x.size();
  scratch.step.setZero(n);
  for (Index j = 0; j < n; ++j) {
    const bool outwards = (x[j] <= problem.lower[j] && gradient[j] > 0) ||
                          (x[j] >= problem.upper[j] && gradient[j] < 0);
    scratch.held[static_cast<std::size_t>(j)] = outwards ? 1 : 0;
  }
  Model model{scratch.now, scratch.now.bend.size() > 0, 0};
  for (int attempt = 0; attempt < 20; ++attempt) {
    if (!free_step(model, false, scratch)) {
      model.damping = std::max(10 * model.damping, model.exact ? 0 : 1e-9);
      model.exact = false;
      continue;
    }
    const double longest = scratch.right_side.cwiseAbs().maxCoeff();
    if (longest <= 1.5 * radius) break;
    // As if the step were all along one curvature, that which the model has along it.
    const double own = model.curved(scratch.right_side) / scratch.right_side.squaredNorm();
    model.damping = std::max(2 * model.damping, longest / radius * (own + model.damping) - own);
  }
  while (stop_at_bounds(problem, scratch)) free_step(model, true, scratch);
  scratch.step.swap(scratch.right_side);
  return {scratch.step.cwiseAbs().maxCoeff(),
          -gradient.dot(scratch.step) - 0.5 * model.curved(scratch.step)};
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

  // Along a curved valley a good step leaves the floor and gains nothing until the next ones are
  // back on it: up to kPatience steps may go uphill before the search returns to where it left.
  constexpr int kPatience = 3;
  constexpr double kFirstStep = 0.1, kLongestStep = 0.5;  // of any variable
  double radius = kFirstStep;
  Step left;
  int uphill = 0;
  const auto go_back = [&] {
    scratch.x.swap(scratch.left_x);
    std::swap(scratch.now, scratch.left);
    radius = left.longest / 4;
    uphill = 0;
  };
  while (result.evaluations < options.evaluations) {
    const Step step = bounded_step(problem, radius, scratch);
    if (step.promised <= options.relative_value * std::abs(scratch.now.value) ||
        step.longest <= options.absolute_step_rad) {
      if (uphill > 0) {
        go_back();
        continue;
      }
      result.converged = true;
      break;
    }
    scratch.trial = (scratch.x + scratch.step).cwiseMax(problem.lower).cwiseMin(problem.upper);
    evaluate(scratch.trial, scratch.next);
    const double gain = scratch.now.value - scratch.next.value;
    const bool better = uphill > 0 ? scratch.left.value - scratch.next.value > 1e-4 * left.promised
                                   : gain > 1e-4 * step.promised;
    if (!better && uphill == kPatience) {
      go_back();
      continue;
    }
    if (better) {
      uphill = 0;
      if (gain > 0.5 * step.promised) radius = std::clamp(2 * step.longest, radius, kLongestStep);
    } else if (uphill++ == 0) {
      scratch.left_x = scratch.x;
      std::swap(scratch.left, scratch.now);
      left = step;
    }
    scratch.x.swap(scratch.trial);
    std::swap(scratch.now, scratch.next);
  }
  if (uphill > 0) go_back();
  result.x = scratch.x;
  result.value = scratch.now.value;
  return result;
}

}  // namespace morphe
