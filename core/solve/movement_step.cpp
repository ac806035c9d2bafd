#include "core/solve/movement_step.hpp"

#include <algorithm>

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
    const auto frame = static_cast<std::size_t>(f);
    hessian.clear_row(frame);
    auto own = hessian.diagonal_block(frame);
    own = point.models[frame].hessian;
    own.diagonal().array() += damping[f];
    own.diagonal() += between[frame].col(0);
    for (Index j = 0; j < n; ++j) {
      if (!held(f, j)) continue;
      own.row(j).setZero();
      own.col(j).setZero();
      own(j, j) = 1;
    }
    for (Index before = 1; before <= std::min(f, BandCholesky::kBandBlocks); ++before) {
      auto joined = hessian.off_diagonal(frame, before);
      for (Index j = 0; j < n; ++j) {
        if (!held(f, j) && !held(f - before, j)) joined[j] = between[frame](j, before);
      }
    }
  }
}

/// Holds free variables that the step would move out of the bounds, at these bounds, and frees held
/// variables that the model's gradient moves back inside. Returns the largest violation of the
/// bounds, and the first frame that changed.
double update_active_set(const MovementProblem& problem, const JointRows& q, const JointRows& slope,
                         JointRows& step, ActiveSet& held, Index& first) {
  double outside = 0;
  first = q.rows();
  for (Index f = 0; f < q.rows(); ++f) {
    for (Index j = 0; j < q.cols(); ++j) {
      const double to = q(f, j) + step(f, j), lower = problem.lower[j], upper = problem.upper[j];
      if (held(f, j)) {
        const double inwards = to > 0.5 * (lower + upper) ? slope(f, j) : -slope(f, j);
        if (inwards <= 0) continue;
        held(f, j) = false;
        first = std::min(first, f);
      } else {
        if (to >= lower && to <= upper) continue;
        step(f, j) = (to < lower ? lower : upper) - q(f, j);
        held(f, j) = true;
        first = std::min(first, f);
        outside = std::max(outside, std::max(lower - to, to - upper));
      }
    }
  }
  return outside;
}

/// Removes the negative curvature from every frame's own model, as far as it is in the subspace of
/// free variables and not outweighed by the damping, one direction at a time as found by the
/// factorisation.
void make_convex(MovementPoint& point, const ActiveSet& held, const JointVector& damping) {
  constexpr double kMinCurvatureRatio = 1e-9;  // relative to the largest curvature
  EnvelopeCholesky factor;
  std::vector<char> own_held(held.cols());
  JointVector down;
  for (Index f = 0; f < point.q.rows(); ++f) {
    Eigen::MatrixXd& hessian = point.models[f].hessian;
    for (Index j = 0; j < held.cols(); ++j) own_held[j] = held(f, j);
    const double least = kMinCurvatureRatio * hessian.diagonal().cwiseAbs().maxCoeff();
    for (Index k = 0; k < 2 * held.cols(); ++k) {
      if (factor.factorise(hessian, damping[f], own_held)) break;
      down = factor.negative_curvature_direction.normalized();
      hessian += (std::max(damping[f] - factor.curvature, least) * down) * down.transpose();
    }
  }
}

/// Computes damped_step() with the given damping.
bool active_set_step(const MovementProblem& problem, const DifferenceCurvature& between,
                     MovementPoint& now, const JointRows& g, const JointVector& damping,
                     BandCholesky& hessian, JointRows& step) {
  constexpr int kMaxActiveSetChanges = 3;
  constexpr double kBoundTolerance_rad = 1e-4;  // that may be removed by clamping
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
    JointRows right = held.select(0, -g);
    if (change > 0) {
      const JointRows held_step = held.select(step, 0);
      right = held.select(held_step, right - multiply(between, now, damping, held_step));
    }
    JointVector solved = Eigen::Map<const JointVector>(right.data(), right.size());
    hessian.solve(solved);
    step = Eigen::Map<const JointRows>(solved.data(), frames, n);
    const JointRows slope = g + multiply(between, now, damping, step);
    if (update_active_set(problem, now.q, slope, step, held, first) <= kBoundTolerance_rad) break;
  }
  return true;
}

/// Damps frames whose steps exceed the range of validity of the models; returns false if there are
/// no such frames.
bool damp_long_steps(const JointRows& g, const JointRows& step, JointVector& damping) {
  constexpr double kMaxStep_rad = 0.5;  // of any variable
  bool any = false;
  for (Index f = 0; f < step.rows(); ++f) {
    const double ratio = step.row(f).cwiseAbs().maxCoeff() / kMaxStep_rad;
    if (ratio <= 1.5) continue;
    // Assumes that the whole step is along a direction of one curvature.
    const double curvature = std::abs(g.row(f).dot(step.row(f))) / step.row(f).squaredNorm();
    damping[f] += std::max(damping[f], (ratio - 1) * curvature);
    any = true;
  }
  return any;
}

}  // namespace

bool damped_step(const MovementProblem& problem, const DifferenceCurvature& between,
                 MovementPoint& now, JointVector& damping, BandCholesky& hessian, JointRows& step) {
  constexpr int kMaxAttempts = 5;
  const JointRows g = gradient(problem, now);
  bool solved = active_set_step(problem, between, now, g, damping, hessian, step);
  for (int k = 0; k < kMaxAttempts && solved && damp_long_steps(g, step, damping); ++k) {
    solved = active_set_step(problem, between, now, g, damping, hessian, step);
  }
  return solved;
}

}  // namespace morphe::solve
