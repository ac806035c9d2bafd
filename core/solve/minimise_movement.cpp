#include "core/solve/minimise_movement.hpp"

#include <algorithm>

#include "core/solve/movement_correction.hpp"
#include "core/solve/movement_model.hpp"
#include "core/solve/movement_step.hpp"

namespace morphe::solve {
namespace {

using Eigen::Index;

/// Adapts the damping. The error of a frame's model may be up to half of D's contribution at a
/// step. If it was larger, the damping becomes the one that would have sufficed; if it was much
/// smaller, the damping is reduced. If a rejected step shows no frame with such an error, all
/// frames are damped, because the same step would otherwise be repeated.
void adapt_damping(const MovementPoint& from, const JointRows& aimed, const MovementPoint& to,
                   bool taken, JointVector& damping) {
  constexpr double kMinDamping = 1e-6, kDampingFallFactor = 5, kDampingRiseFactor = 1000,
                   kAcceptedRiseFactor = 2, kCommonRiseFactor = 4;
  const JointVector wrong = model_error(from, aimed, to);
  bool any_wrong = false;
  for (Index f = 0; f < from.q.rows(); ++f) {
    const double squared = (aimed.row(f) - from.q.row(f)).squaredNorm();
    if (squared == 0) continue;
    const double enough = 2 * wrong[f] / squared;
    if (enough > damping[f]) {
      any_wrong = true;
      damping[f] = taken ? std::min(enough, kAcceptedRiseFactor * damping[f])
                         : std::clamp(enough, 2 * damping[f], kDampingRiseFactor * damping[f]);
    } else if (taken && enough < damping[f] / 4) {
      damping[f] = std::max(damping[f] / kDampingFallFactor, kMinDamping);
    }
  }
  if (!taken && !any_wrong) damping *= kCommonRiseFactor;
}

void clamp(const MovementProblem& problem, JointRows& q) {
  for (Index f = 0; f < q.rows(); ++f) {
    q.row(f) = q.row(f).cwiseMax(problem.lower.transpose()).cwiseMin(problem.upper.transpose());
  }
}

}  // namespace

MovementMinimum minimise_movement(const MovementProblem& problem, const JointRows& start,
                                  const MovementOptions& options) {
  constexpr double kInitialDamping = 3;
  constexpr double kMaxDamping = 1e12;
  MovementPoint now, next, corrected;
  now.q = start;
  clamp(problem, now.q);
  evaluate(problem, now);

  BandCholesky hessian;
  hessian.resize(problem.frames, start.cols());
  const DifferenceCurvature between = difference_curvature(problem);
  JointVector damping = JointVector::Constant(now.q.rows(), kInitialDamping);
  // A step is corrected for the first time if it decreases the value by less than kMinGainRatio of
  // the prediction; again as long as it does not decrease the value, unless the increase exceeds
  // the possible decrease many times.
  constexpr int kMaxCorrections = 3;
  constexpr double kMinGainRatio = 0.7, kMaxLossRatio = 10;
  const auto step_to = [&](const JointRows& aimed) {
    next.q = aimed;
    evaluate(problem, next);
    const double promised = now.value - next.value + model_error(now, aimed, next).sum();
    for (int k = 0; k < kMaxCorrections; ++k) {
      const double gain = now.value - next.value;
      if (k == 0 ? gain > kMinGainRatio * promised : gain > 0 || -gain > kMaxLossRatio * promised)
        break;
      correct_step(problem, between, now, aimed, next, damping, corrected.q);
      clamp(problem, corrected.q);
      evaluate(problem, corrected);
      if (!(corrected.value < next.value)) break;
      std::swap(next, corrected);
    }
  };
  JointRows step, aimed;
  int small = 0;
  MovementMinimum result;
  while (result.iterations < options.max_iterations && small < 2 &&
         damping.minCoeff() <= kMaxDamping) {
    ++result.iterations;
    if (!damped_step(problem, between, now, damping, hessian, step)) {
      damping *= 8;
      continue;
    }
    aimed = now.q + step;
    clamp(problem, aimed);
    step_to(aimed);
    const bool taken = next.value < now.value;
    adapt_damping(now, aimed, next, taken, damping);
    if (!taken) continue;
    small = now.value - next.value < options.relative_tolerance * now.value ? small + 1 : 0;
    std::swap(now, next);
  }
  result.converged = small == 2;
  result.q = now.q;
  result.value = now.value;
  result.frame_value = now.frame_value;
  return result;
}

}  // namespace morphe::solve
