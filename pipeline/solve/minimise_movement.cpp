#include "pipeline/solve/minimise_movement.hpp"

#include <algorithm>

#include "pipeline/solve/movement_model.hpp"
#include "pipeline/solve/movement_step.hpp"

namespace morphe::solve {
namespace {

using Eigen::Index;

/// Half of D's share at a step bounds what a frame's own model may be wrong by. Where it did not,
/// the damping that would have been enough; where it was far too much, less. If a step that is not
/// taken blames no frame, all are damped: the same step again would end the same.
void adapt(const MovementPoint& from, const MovementPoint& to, bool taken, JointVector& damping) {
  constexpr double kLeast = 1e-6, kFall = 5, kRise = 1000, kRiseIfTaken = 2, kRiseOfAll = 4;
  JointVector step, bent;
  bool any_wrong = false;
  for (Index f = 0; f < from.q.rows(); ++f) {
    const Quadratic& model = from.models[static_cast<std::size_t>(f)];
    step = (to.q.row(f) - from.q.row(f)).transpose();
    const double squared = step.squaredNorm();
    if (squared == 0) continue;
    bent.noalias() = model.hessian * step;
    const double wrong = to.models[static_cast<std::size_t>(f)].value - model.value -
                         step.dot(model.gradient + 0.5 * bent);
    const double enough = 2 * wrong / squared;
    if (enough > damping[f]) {
      any_wrong = true;
      damping[f] = taken ? std::min(enough, kRiseIfTaken * damping[f])
                         : std::clamp(enough, 2 * damping[f], kRise * damping[f]);
    } else if (taken && enough < damping[f] / 4) {
      damping[f] = std::max(damping[f] / kFall, kLeast);
    }
  }
  if (!taken && !any_wrong) damping *= kRiseOfAll;
}

void clamp(const MovementProblem& problem, JointRows& q) {
  for (Index f = 0; f < q.rows(); ++f) {
    q.row(f) = q.row(f).cwiseMax(problem.lower.transpose()).cwiseMin(problem.upper.transpose());
  }
}

}  // namespace

MovementMinimum minimise_movement(const MovementProblem& problem, const JointRows& start,
                                  const MovementOptions& options) {
  constexpr int kPatience = 2;        // steps that may go uphill
  constexpr double kFarUphill = 1.1;  // and how high, times the value below
  constexpr double kFirstDamping = 3;
  constexpr double kMostDamping = 1e12;
  MovementPoint now, next, left, over;  // `left` by a step uphill to `over`
  now.q = start;
  clamp(problem, now.q);
  evaluate(problem, now);

  BandCholesky hessian;
  hessian.resize(problem.frames, start.cols());
  const DifferenceCurvature between = difference_curvature(problem);
  JointRows step;
  JointVector damping = JointVector::Constant(now.q.rows(), kFirstDamping);
  int uphill = 0, small = 0;
  MovementMinimum result;
  while (result.iterations < options.iterations && small < 2 &&
         damping.minCoeff() <= kMostDamping) {
    ++result.iterations;
    if (!short_step(problem, between, now, damping, hessian, step)) {
      damping *= 8;
      continue;
    }
    next.q = now.q + step;
    clamp(problem, next.q);
    evaluate(problem, next);
    const double before = uphill > 0 ? left.value : now.value;
    if (next.value < before) {
      small = before - next.value < options.relative_value * before ? small + 1 : 0;
      adapt(now, next, true, damping);
      std::swap(now, next);
      uphill = 0;
    } else if (uphill < kPatience && next.value < kFarUphill * before) {
      if (uphill++ == 0) {
        std::swap(left, now);
        over = next;
      }
      std::swap(now, next);
    } else {
      if (uphill > 0) {
        std::swap(now, left);
        std::swap(next, over);
      }
      adapt(now, next, false, damping);
      uphill = 0;
    }
  }
  if (uphill > 0) std::swap(now, left);
  result.converged = small == 2;
  result.q = now.q;
  result.value = now.value;
  result.frame_value = now.frame_value;
  return result;
}

}  // namespace morphe::solve
