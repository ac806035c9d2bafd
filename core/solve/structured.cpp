#include "core/solve/structured.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace morphe::solve {
namespace {

using Eigen::Index;

struct Step {
  double longest = 0;   ///< largest entry
  double promised = 0;  ///< what the model gains by it
};

/// product = (H + damping I) v.
void multiply(const Quadratic& at, double damping, const JointVector& v, JointVector& product) {
  product.noalias() = at.hessian * v;
  product += damping * v;
}

/// Newton's step from x + step by the free variables, into `scratch.move`; false if the Hessian is
/// not positive definite there.
bool free_move(double damping, StructuredScratch& scratch) {
  if (!scratch.factor.factorise(scratch.now.hessian, damping, scratch.held)) return false;
  scratch.move = -scratch.slope;
  for (Index j = 0; j < scratch.move.size(); ++j) {
    if (scratch.held[static_cast<std::size_t>(j)]) scratch.move[j] = 0;
  }
  scratch.factor.solve(scratch.move);
  return true;
}

/// The held variable that the model would rather have inside its bounds, most of all; -1: none.
Index wrongly_held(const BoundedProblem& problem, const StructuredScratch& scratch) {
  Index worst = -1;
  double most = 0;
  for (Index j = 0; j < scratch.x.size(); ++j) {
    if (!scratch.held[static_cast<std::size_t>(j)]) continue;
    const bool upper = scratch.x[j] + scratch.step[j] >= problem.upper[j];
    const double inwards = upper ? scratch.slope[j] : -scratch.slope[j];
    if (inwards > most) {
      most = inwards;
      worst = j;
    }
  }
  return worst;
}

/// Adds the move to the step, or as much of it as the bounds allow; the variable that stopped it is
/// held. False if nothing did.
bool stopped_move(const BoundedProblem& problem, double damping, StructuredScratch& scratch) {
  double share = 1;
  Index stopped = -1;
  for (Index j = 0; j < scratch.x.size(); ++j) {
    const double from = scratch.x[j] + scratch.step[j], to = from + scratch.move[j];
    const double bound = std::clamp(to, problem.lower[j], problem.upper[j]);
    if (bound == to || scratch.held[static_cast<std::size_t>(j)]) continue;
    const double possible = std::max(0.0, (bound - from) / scratch.move[j]);
    if (possible < share) {
      share = possible;
      stopped = j;
    }
  }
  multiply(scratch.now, damping, scratch.move, scratch.bent);
  scratch.step += share * scratch.move;
  scratch.slope += share * scratch.bent;
  if (stopped < 0) return false;
  const bool upper = scratch.move[stopped] > 0;
  scratch.step[stopped] = (upper ? problem.upper : problem.lower)[stopped] - scratch.x[stopped];
  scratch.held[static_cast<std::size_t>(stopped)] = 1;
  return true;
}

/// Minimises the model within the bounds, into `scratch.step`: from one set of held variables to
/// the next, always downhill. False if the Hessian is not positive definite, or the step far too
/// long.
bool minimise_model(const BoundedProblem& problem, double damping, double longest,
                    StructuredScratch& scratch) {
  const Index n = scratch.x.size();
  scratch.step.setZero(n);
  scratch.slope = scratch.now.gradient;
  for (Index j = 0; j < n; ++j) {
    const bool outwards = (scratch.x[j] <= problem.lower[j] && scratch.slope[j] > 0) ||
                          (scratch.x[j] >= problem.upper[j] && scratch.slope[j] < 0);
    scratch.held[static_cast<std::size_t>(j)] = outwards ? 1 : 0;
  }
  for (Index change = 0; change < 3 * n; ++change) {
    if (!free_move(damping, scratch)) return false;
    if (scratch.move.cwiseAbs().maxCoeff() > longest) {
      scratch.step += scratch.move;
      return false;
    }
    if (stopped_move(problem, damping, scratch)) continue;
    const Index freed = wrongly_held(problem, scratch);
    if (freed < 0) break;
    scratch.held[static_cast<std::size_t>(freed)] = 0;
  }
  return true;
}

/// The model's step within the bounds, damped until its entries are near or below the radius.
Step bounded_step(const BoundedProblem& problem, double radius, StructuredScratch& scratch) {
  // Directions in which nothing is known to be curved would magnify round-off without a floor.
  constexpr double kFloor = 1e-12, kNone = 1e-6;
  const double largest = scratch.now.hessian.diagonal().cwiseAbs().maxCoeff();
  double damping = kFloor * largest;
  // Less would mostly not do: a good part of the last step's damping is needed again.
  if (scratch.damping > kNone * largest) damping = std::max(damping, scratch.damping / 30);
  for (int attempt = 0; attempt < 40; ++attempt) {
    scratch.factor.missing = 0;
    if (minimise_model(problem, damping, 1.5 * radius, scratch)) break;
    if (scratch.factor.missing > 0) {
      // The last step's damping tells the order of magnitude; more than needed would cost steps.
      damping += std::max({3 * damping, 2 * scratch.factor.missing, 0.3 * scratch.damping});
      continue;
    }
    // As if the step were all along one curvature, that which the model has along it.
    multiply(scratch.now, damping, scratch.step, scratch.bent);
    const double damped = scratch.step.dot(scratch.bent) / scratch.step.squaredNorm();
    const double ratio = scratch.step.cwiseAbs().maxCoeff() / radius;
    damping += std::max(damping, (ratio - 1) * damped);
  }
  scratch.damping = damping;
  multiply(scratch.now, 0, scratch.step, scratch.bent);
  return {scratch.step.cwiseAbs().maxCoeff(),
          -scratch.step.dot(scratch.now.gradient + 0.5 * scratch.bent)};
}

}  // namespace

Minimum minimise_structured(const BoundedProblem& problem, const JointVector& start,
                            const MinimiseOptions& options, StructuredScratch& scratch) {
  assert(problem.model);
  const Index n = start.size();
  scratch.damping = 0;
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
    radius = std::min(radius, left.longest) / 4;
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
    for (Index j = 0; j < n; ++j) {  // what is held is on its bound to the last bit
      if (!scratch.held[static_cast<std::size_t>(j)]) continue;
      const double middle = 0.5 * (problem.lower[j] + problem.upper[j]);
      scratch.trial[j] = (scratch.trial[j] > middle ? problem.upper : problem.lower)[j];
    }
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

}  // namespace morphe::solve
