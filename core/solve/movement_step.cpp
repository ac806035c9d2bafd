#include "core/solve/movement_step.hpp"

#include <algorithm>

#include "core/solve/envelope_cholesky.hpp"

namespace morphe::solve {
namespace {

using Eigen::Index;
using Held = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// H + D with held variables cut out, from a frame on.
void damped_hessian(const DifferenceCurvature& between, const MovementPoint& point,
                    const Held& held, const JointVector& damping, Index first,
                    BandCholesky& hessian) {
  const Index frames = point.q.rows(), n = point.q.cols();
  for (Index f = first; f < frames; ++f) {
    const auto frame = static_cast<std::size_t>(f);
    hessian.clear(frame);
    auto own = hessian.own(frame);
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
      auto joined = hessian.between(frame, before);
      for (Index j = 0; j < n; ++j) {
        if (!held(f, j) && !held(f - before, j)) joined[j] = between[frame](j, before);
      }
    }
  }
}

/// Holds free variables that the step takes out of the bounds, on them, and frees held ones that
/// the slope of the model draws back inside; by how much the bounds were left, and the first frame
/// of those changed.
double change_held(const MovementProblem& problem, const JointRows& q, const JointRows& slope,
                   JointRows& step, Held& held, Index& first) {
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

/// Takes the negative curvature out of every frame's own model, where free variables see it and the
/// damping does not outweigh it: direction by direction, as the factorization meets them.
void make_convex(MovementPoint& point, const Held& held, const JointVector& damping) {
  constexpr double kLeast = 1e-9;  // of the largest curvature: clearly positive
  EnvelopeCholesky factor;
  std::vector<char> own_held(static_cast<std::size_t>(held.cols()));
  JointVector down;
  for (Index f = 0; f < point.q.rows(); ++f) {
    Eigen::MatrixXd& hessian = point.models[static_cast<std::size_t>(f)].hessian;
    for (Index j = 0; j < held.cols(); ++j) own_held[static_cast<std::size_t>(j)] = held(f, j);
    const double least = kLeast * hessian.diagonal().cwiseAbs().maxCoeff();
    for (Index k = 0; k < 2 * held.cols(); ++k) {
      if (factor.factorise(hessian, damping[f], own_held)) break;
      down = factor.direction.normalized();
      hessian += (std::max(damping[f] - factor.curvature, least) * down) * down.transpose();
    }
  }
}

/// short_step() as the damping is.
bool bounded_step(const MovementProblem& problem, const DifferenceCurvature& between,
                  MovementPoint& now, const JointRows& g, const JointVector& damping,
                  BandCholesky& hessian, JointRows& step) {
  constexpr int kChanges = 3;
  constexpr double kOutside = 1e-4;  // clamping may cut off
  const Index frames = now.q.rows(), n = now.q.cols();
  Held held(frames, n);
  for (Index f = 0; f < frames; ++f) {
    for (Index j = 0; j < n; ++j) {
      held(f, j) = (now.q(f, j) <= problem.lower[j] && g(f, j) > 0) ||
                   (now.q(f, j) >= problem.upper[j] && g(f, j) < 0);
    }
  }
  step.setZero(frames, n);
  Index first = 0;  // frame with another set of held variables
  for (int change = 0; change < kChanges; ++change) {
    damped_hessian(between, now, held, damping, first, hessian);
    if (!hessian.factorise(static_cast<std::size_t>(first))) {
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
    if (change_held(problem, now.q, slope, step, held, first) <= kOutside) break;
  }
  return true;
}

/// Damps frames whose steps are longer than models hold; false if there is none.
bool damp_long(const JointRows& g, const JointRows& step, JointVector& damping) {
  constexpr double kLongest = 0.5;  // of any variable
  bool any = false;
  for (Index f = 0; f < step.rows(); ++f) {
    const double ratio = step.row(f).cwiseAbs().maxCoeff() / kLongest;
    if (ratio <= 1.5) continue;
    // As if the step were all along one curvature.
    const double curvature = std::abs(g.row(f).dot(step.row(f))) / step.row(f).squaredNorm();
    damping[f] += std::max(damping[f], (ratio - 1) * curvature);
    any = true;
  }
  return any;
}

}  // namespace

bool short_step(const MovementProblem& problem, const DifferenceCurvature& between,
                MovementPoint& now, JointVector& damping, BandCholesky& hessian, JointRows& step) {
  constexpr int kAttempts = 5;
  const JointRows g = gradient(problem, now);
  bool solved = bounded_step(problem, between, now, g, damping, hessian, step);
  for (int k = 0; k < kAttempts && solved && damp_long(g, step, damping); ++k) {
    solved = bounded_step(problem, between, now, g, damping, hessian, step);
  }
  return solved;
}

}  // namespace morphe::solve
