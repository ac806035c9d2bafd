#include "core/solve/minimise_movement.hpp"

#include <algorithm>

#include "core/solve/movement_correction.hpp"
#include "core/solve/movement_model.hpp"
#include "core/solve/movement_step.hpp"

namespace morphe::solve {
namespace {

using Eigen::Index;

/// Half of D's share at a step bounds what a frame's own model may be wrong by. Where it did not,
/// the damping that would have been enough; where it was far too much, less. If a step that is not
/// taken blames no frame, all are damped: the same step again would end the same.
void adapt(const MovementPoint& from, const JointRows& aimed, const MovementPoint& to, bool taken,
           JointVector& damping) {
  constexpr double kLeast = 1e-6, kFall = 5, kRise = 1000, kRiseIfTaken = 2, kRiseOfAll = 4;
  const JointVector wrong = wrong_by(from, aimed, to);
  bool any_wrong = false;
  for (Index f = 0; f < from.q.rows(); ++f) {
    const double squared = (aimed.row(f) - from.q.row(f)).squaredNorm();
    if (squared == 0) continue;
    const double enough = 2 * wrong[f] / squared;
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
  constexpr double kFirstDamping = 3;
  constexpr double kMostDamping = 1e12;
  MovementPoint now, next, corrected;
  now.q = start;
  clamp(problem, now.q);
  evaluate(problem, now);

  BandCholesky hessian;
  hessian.resize(problem.frames, start.cols());
  const DifferenceCurvature between = difference_curvature(problem);
  JointVector damping = JointVector::Constant(now.q.rows(), kFirstDamping);
  // A step's first correction where it gains less than kKept of what it promised; another one while
  // it gains nothing, if what is missing is not many times what there is to gain.
  constexpr int kCorrections = 3;
  constexpr double kKept = 0.7, kNear = 10;
  const auto step_to = [&](const JointRows& aimed) {
    next.q = aimed;
    evaluate(problem, next);
    const double promised = now.value - next.value + wrong_by(now, aimed, next).sum();
    for (int k = 0; k < kCorrections; ++k) {
      const double gain = now.value - next.value;
      if (k == 0 ? gain > kKept * promised : gain > 0 || -gain > kNear * promised) break;
      correct(problem, between, now, aimed, next, damping, corrected.q);
      clamp(problem, corrected.q);
      evaluate(problem, corrected);
      if (!(corrected.value < next.value)) break;
      std::swap(next, corrected);
    }
  };
  JointRows step, aimed;
  int small = 0;
  MovementMinimum result;
  while (result.iterations < options.iterations && small < 2 &&
         damping.minCoeff() <= kMostDamping) {
    ++result.iterations;
    if (!short_step(problem, between, now, damping, hessian, step)) {
      damping *= 8;
      continue;
    }
    aimed = now.q + step;
    clamp(problem, aimed);
    step_to(aimed);
    const bool taken = next.value < now.value;
    adapt(now, aimed, next, taken, damping);
    if (!taken) continue;
    small = now.value - next.value < options.relative_value * now.value ? small + 1 : 0;
    std::swap(now, next);
  }
  result.converged = small == 2;
  result.q = now.q;
  result.value = now.value;
  result.frame_value = now.frame_value;
  return result;
}

}  // namespace morphe::solve
