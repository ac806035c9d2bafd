#include "pipeline/solve/minimise_movement.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "pipeline/solve/band_cholesky.hpp"

namespace morphe {
namespace {

using Eigen::Index;
/// Coefficients of the forward differences of order 1, 2 and 3.
const std::array<std::vector<double>, 3> kDifferences{{{-1, 1}, {1, -2, 1}, {-1, 3, -3, 1}}};

/// Everything at one point of the search.
struct Point {
  JointRows q;
  std::vector<Quadratic> models;
  double frame_value = 0, value = 0;
};

JointVector difference(const JointRows& q, Index f, const std::vector<double>& coefficients) {
  JointVector sum = JointVector::Zero(q.cols());
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    sum += coefficients[k] * q.row(f + static_cast<Index>(k)).transpose();
  }
  return sum;
}

/// Calls visit(first frame, coefficients, weight) for every difference of the movement.
template <class Visit>
void each_difference(const MovementProblem& problem, const Visit& visit) {
  for (std::size_t order = 0; order < kDifferences.size(); ++order) {
    const auto span = static_cast<Index>(kDifferences[order].size());
    for (Index f = 0; f + span <= static_cast<Index>(problem.frames); ++f) {
      visit(f, kDifferences[order], problem.difference_weight[order]);
    }
  }
}

void evaluate(const MovementProblem& problem, Point& point) {
  const Index n = point.q.cols();
  point.models.resize(problem.frames);
  point.frame_value = 0;
  JointVector q(n);
  for (std::size_t f = 0; f < problem.frames; ++f) {
    point.models[f].reset(n);
    q = point.q.row(static_cast<Index>(f));
    problem.frame_model(f, q, point.models[f]);
    point.frame_value += point.models[f].value;
  }
  point.value = point.frame_value;
  each_difference(problem, [&](Index f, const auto& coefficients, const JointVector& weight) {
    point.value += difference(point.q, f, coefficients).cwiseAbs2().dot(weight);
  });
}

JointRows gradient(const MovementProblem& problem, const Point& point) {
  JointRows g(point.q.rows(), point.q.cols());
  for (Index f = 0; f < g.rows(); ++f) {
    g.row(f) = point.models[static_cast<std::size_t>(f)].gradient.transpose();
  }
  each_difference(problem, [&](Index f, const auto& coefficients, const JointVector& weight) {
    const JointVector weighted = 2 * difference(point.q, f, coefficients).cwiseProduct(weight);
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
      g.row(f + static_cast<Index>(k)) += coefficients[k] * weighted.transpose();
    }
  });
  return g;
}

/// The Hessian with held variables cut out and the diagonal damped.
void damped_hessian(const MovementProblem& problem, const Point& point,
                    const std::vector<bool>& held, double damping, BandCholesky& hessian) {
  const Index frames = point.q.rows(), n = point.q.cols();
  for (Index f = 0; f < frames; ++f) {
    const auto frame = static_cast<std::size_t>(f);
    const Eigen::MatrixXd& own = point.models[frame].hessian;
    // Directions without curvature of their own are damped too, or they take wild steps.
    const double floor = 1e-3 * own.diagonal().maxCoeff() + 1e-9;
    hessian.row(frame).setZero();
    auto block = hessian.block(frame, 0);
    block = own;
    block.diagonal() += damping * (own.diagonal().array() + floor).matrix();
  }
  each_difference(problem, [&](Index f, const auto& coefficients, const JointVector& weight) {
    for (std::size_t a = 0; a < coefficients.size(); ++a) {
      for (std::size_t b = 0; b <= a; ++b) {
        hessian.block(static_cast<std::size_t>(f) + a, static_cast<Index>(a - b)).diagonal() +=
            2 * coefficients[a] * coefficients[b] * weight;
      }
    }
  });
  for (Index k = 0; k < frames * n; ++k) {
    if (!held[static_cast<std::size_t>(k)]) continue;
    const auto frame = static_cast<std::size_t>(k / n);
    hessian.row(frame).row(k % n).setZero();
    for (Index after = 0; after <= BandCholesky::kBandBlocks; ++after) {
      const std::size_t below = frame + static_cast<std::size_t>(after);
      if (below < problem.frames) hessian.block(below, after).col(k % n).setZero();
    }
    hessian.block(frame, 0)(k % n, k % n) = 1;
  }
}

}  // namespace

MovementMinimum minimise_movement(const MovementProblem& problem, const JointRows& start,
                                  const MovementOptions& options) {
  const Index frames = start.rows(), n = start.cols();
  Point now, next;
  now.q = start;
  const auto clamp = [&](JointRows& q) {
    for (Index f = 0; f < frames; ++f) {
      q.row(f) = q.row(f).cwiseMax(problem.lower.transpose()).cwiseMin(problem.upper.transpose());
    }
  };
  clamp(now.q);
  evaluate(problem, now);

  BandCholesky hessian;
  hessian.resize(problem.frames, n);
  double damping = 1e-3;
  MovementMinimum result;
  std::vector<bool> held(static_cast<std::size_t>(frames * n));
  for (result.iterations = 0; result.iterations < options.iterations; ++result.iterations) {
    const JointRows g = gradient(problem, now);
    JointVector step(frames * n);
    for (Index f = 0; f < frames; ++f) {
      for (Index j = 0; j < n; ++j) {
        const bool at_lower = now.q(f, j) <= problem.lower[j] && g(f, j) > 0;
        const bool at_upper = now.q(f, j) >= problem.upper[j] && g(f, j) < 0;
        held[static_cast<std::size_t>(f * n + j)] = at_lower || at_upper;
        step[f * n + j] = at_lower || at_upper ? 0 : -g(f, j);
      }
    }
    damped_hessian(problem, now, held, damping, hessian);
    if (!hessian.factorise()) {
      damping *= 8;
      continue;
    }
    hessian.solve(step);
    next.q = now.q + Eigen::Map<const JointRows>(step.data(), frames, n);
    clamp(next.q);
    evaluate(problem, next);
    if (next.value < now.value) {
      const double gain = now.value - next.value;
      std::swap(now, next);
      damping = std::max(damping / 5, 1e-9);
      if (gain < options.relative_value * now.value) {
        result.converged = true;
        break;
      }
    } else {
      damping *= 8;
      if (damping > 1e6) {
        result.converged = true;
        break;
      }
    }
  }
  result.q = now.q;
  result.value = now.value;
  result.frame_value = now.frame_value;
  return result;
}

}  // namespace morphe
