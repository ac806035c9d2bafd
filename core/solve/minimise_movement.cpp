#include "core/solve/minimise_movement.hpp"

#include <algorithm>

#include "core/solve/constants.hpp"
#include "core/solve/movement_correction.hpp"
#include "core/solve/movement_model.hpp"
#include "core/solve/movement_step.hpp"

namespace morphe::solve {
namespace {

using Eigen::Index;

/// Adapts the damping D. The error of a frame's model may be up to half of D's contribution at a
/// step. If it was larger, the damping rises to the one that was needed, within limits; if it was
/// much smaller, the damping falls. If a rejected step shows no frame with such an error, all
/// frames are damped, because the same step would otherwise be repeated.
void adapt_damping(const MovementPoint& begin, const JointRows& aimed, const MovementPoint& end,
                   bool accepted, JointVector& damping) {
  const JointVector error = model_error(begin, aimed, end);
  bool any_wrong = false;
  for (Index f = 0; f < begin.q.rows(); ++f) {
    const double squared = (aimed.row(f) - begin.q.row(f)).squaredNorm();
    if (squared == 0) continue;
    const double needed = 2 * error[f] / squared;
    if (needed > damping[f]) {
      any_wrong = true;
      damping[f] = accepted ? std::min(needed, kAcceptedRise * damping[f])
                            : std::clamp(needed, kMinRejectedRise * damping[f],
                                         kMaxRejectedRise * damping[f]);
    } else if (accepted && needed < damping[f] / kNeededDampingFactor) {
      damping[f] = std::max(damping[f] / kDampingFall, kMinFrameDamping);
    }
  }
  if (!accepted && !any_wrong) damping *= kCommonRise;
}

void clamp(const MovementProblem& problem, JointRows& q) {
  for (Index f = 0; f < q.rows(); ++f)
    q.row(f) = q.row(f).cwiseMax(problem.lower.transpose()).cwiseMin(problem.upper.transpose());
}

}  // namespace

MovementMinimum minimise_movement(const MovementProblem& problem, const JointRows& start,
                                  const MovementOptions& options) {
  MovementPoint now, next, corrected;
  now.q = start;
  clamp(problem, now.q);
  evaluate(problem, now);

  BandCholesky hessian;
  hessian.resize(problem.frames, start.cols());
  const DifferenceCurvature between = difference_curvature(problem);
  JointVector damping = JointVector::Constant(now.q.rows(), kInitialFrameDamping);
  const auto step_to = [&](const JointRows& aimed) {
    next.q = aimed;
    evaluate(problem, next);
    const double predicted = now.value - next.value + model_error(now, aimed, next).sum();
    for (int k = 0; k < kMaxCorrections; ++k) {
      const double gain = now.value - next.value;
      if (k == 0 ? gain > kMinGainRatio * predicted : gain > 0 || -gain > kMaxLossRatio * predicted)
        break;
      correct_step(problem, between, now, aimed, next, damping, corrected.q);
      clamp(problem, corrected.q);
      evaluate(problem, corrected);
      if (!(corrected.value < next.value)) break;
      std::swap(next, corrected);
    }
  };
  JointRows step, aimed;
  int small_steps = 0;
  MovementMinimum result;
  while (result.iterations < options.max_iterations && small_steps < kSmallStepsToConverge &&
         damping.minCoeff() <= kMaxFrameDamping) {
    ++result.iterations;
    if (!damped_step(problem, between, now, damping, hessian, step)) {
      damping *= kNoStepRise;
      continue;
    }
    aimed = now.q + step;
    clamp(problem, aimed);
    step_to(aimed);
    const bool accepted = next.value < now.value;
    adapt_damping(now, aimed, next, accepted, damping);
    if (!accepted) continue;
    small_steps =
        now.value - next.value < options.relative_tolerance * now.value ? small_steps + 1 : 0;
    std::swap(now, next);
  }
  result.converged = small_steps == kSmallStepsToConverge;
  result.q = now.q;
  result.value = now.value;
  result.frame_value = now.frame_value;
  return result;
}

}  // namespace morphe::solve
