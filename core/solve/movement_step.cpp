#include "core/solve/movement_step.hpp"

#include <algorithm>

#include "core/solve/constants.hpp"
#include "core/solve/envelope_cholesky.hpp"

namespace morphe::solve {
namespace {

using Eigen::Index;
using ActiveSet = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Computes H + D without held variables, from a frame on.
void damped_hessian(const DifferenceCurvature& between, const MovementPoint& point,
                    const ActiveSet& held, const JointVector& damping, Index first,
                    BandCholesky& hessian) {
  const Index frames = point.q.rows(), n = point.q.cols();
  for (Index f = first; f < frames; ++f) {
    hessian.clear_row(f);
    auto own = hessian.diagonal_block(f);
    own = point.models[f].hessian;
    own.diagonal().array() += damping[f];
    own.diagonal() += between[f].col(0);
    for (Index j = 0; j < n; ++j) {
      if (!held(f, j)) continue;
      own.row(j).setZero();
      own.col(j).setZero();
      own(j, j) = 1;
    }
    for (Index before = 1; before <= std::min(f, BandCholesky::kBandBlocks); ++before) {
      auto joined = hessian.off_diagonal(f, before);
      for (Index j = 0; j < n; ++j)
        if (!held(f, j) && !held(f - before, j)) joined[j] = between[f](j, before);
    }
  }
}

/// Holds free variables at the bounds that the step would cross, and frees held variables that the
/// model's gradient moves inside. Returns the largest violation; sets the first changed frame.
double update_active_set(const MovementProblem& problem, const JointRows& q, const JointRows& slope,
                         JointRows& step, ActiveSet& held, Index& first) {
  double max_violation = 0;
  first = q.rows();
  for (Index f = 0; f < q.rows(); ++f) {
    for (Index j = 0; j < q.cols(); ++j) {
      const double x = q(f, j) + step(f, j), lower = problem.lower[j], upper = problem.upper[j];
      if (held(f, j)) {
        const double inwards = x > 0.5 * (lower + upper) ? slope(f, j) : -slope(f, j);
        if (inwards <= 0) continue;
        held(f, j) = false;
        first = std::min(first, f);
      } else {
        if (x >= lower && x <= upper) continue;
        step(f, j) = (x < lower ? lower : upper) - q(f, j);
        held(f, j) = true;
        first = std::min(first, f);
        max_violation = std::max(max_violation, std::max(lower - x, x - upper));
      }
    }
  }
  return max_violation;
}

/// Removes negative curvature from every frame's own model, in the subspace of free variables and
/// where the damping does not outweigh it, v by v as the factorisation finds them.
void make_convex(MovementPoint& point, const ActiveSet& held, const JointVector& damping) {
  EnvelopeCholesky factor;
  std::vector<char> own_held(held.cols());
  JointVector v;
  for (Index f = 0; f < point.q.rows(); ++f) {
    Eigen::MatrixXd& hessian = point.models[f].hessian;
    for (Index j = 0; j < held.cols(); ++j) own_held[j] = held(f, j);
    const double min_curvature = kMinCurvatureRatio * hessian.diagonal().cwiseAbs().maxCoeff();
    for (Index k = 0; k < 2 * held.cols(); ++k) {
      if (factor.factorise(hessian, damping[f], own_held)) break;
      v = factor.negative_curvature_direction.normalized();
      hessian += (std::max(damping[f] - factor.curvature, min_curvature) * v) * v.transpose();
    }
  }
}

bool active_set_step(const MovementProblem& problem, const DifferenceCurvature& between,
                     MovementPoint& now, const JointRows& g, const JointVector& damping,
                     BandCholesky& hessian, JointRows& step) {
  const Index frames = now.q.rows(), n = now.q.cols();
  ActiveSet held(frames, n);
  for (Index f = 0; f < frames; ++f) {
    for (Index j = 0; j < n; ++j) {
      held(f, j) = (now.q(f, j) <= problem.lower[j] && g(f, j) > 0) ||
                   (now.q(f, j) >= problem.upper[j] && g(f, j) < 0);
    }
  }
  step.setZero(frames, n);
  Index first = 0;  // first frame whose active set has changed
  for (int change = 0; change < kMaxActiveSetChanges; ++change) {
    damped_hessian(between, now, held, damping, first, hessian);
    if (!hessian.factorise(first)) {
      make_convex(now, held, damping);
      damped_hessian(between, now, held, damping, 0, hessian);
      if (!hessian.factorise()) return false;
    }
    JointRows right_side = held.select(0, -g);
    if (change > 0) {
      const JointRows held_step = held.select(step, 0);
      right_side = held.select(held_step, right_side - multiply(between, now, damping, held_step));
    }
    JointVector solved = Eigen::Map<const JointVector>(right_side.data(), right_side.size());
    hessian.solve(solved);
    step = Eigen::Map<const JointRows>(solved.data(), frames, n);
    const JointRows slope = g + multiply(between, now, damping, step);
    if (update_active_set(problem, now.q, slope, step, held, first) <= kBoundTolerance_rad) break;
  }
  return true;
}

/// Damps frames whose steps exceed the models' range of validity; returns true if any does.
bool damp_long_steps(const JointRows& g, const JointRows& step, JointVector& damping) {
  bool any = false;
  for (Index f = 0; f < step.rows(); ++f) {
    const double ratio = step.row(f).cwiseAbs().maxCoeff() / kMaxFrameStep_rad;
    if (ratio <= kFrameStepExcessFactor) continue;
    // Assumes that the whole step is along a v of one curvature.
    const double curvature = std::abs(g.row(f).dot(step.row(f))) / step.row(f).squaredNorm();
    damping[f] += std::max(damping[f], (ratio - 1) * curvature);
    any = true;
  }
  return any;
}

}  // namespace

bool damped_step(const MovementProblem& problem, const DifferenceCurvature& between,
                 MovementPoint& now, JointVector& damping, BandCholesky& hessian, JointRows& step) {
  const JointRows g = gradient(problem, now);
  bool solved = active_set_step(problem, between, now, g, damping, hessian, step);
  for (int k = 0; k < kMaxLongStepDampings && solved && damp_long_steps(g, step, damping); ++k)
    solved = active_set_step(problem, between, now, g, damping, hessian, step);
  return solved;
}

}  // namespace morphe::solve
