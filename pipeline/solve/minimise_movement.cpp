#include "pipeline/solve/minimise_movement.hpp"

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <vector>

namespace morphe {
namespace {

using Eigen::Index;
using Sparse = Eigen::SparseMatrix<double>;
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

/// Lower triangle of the Hessian with held variables cut out and the diagonal damped.
Sparse damped_hessian(const MovementProblem& problem, const Point& point,
                      const std::vector<bool>& held, double damping) {
  const Index frames = point.q.rows(), n = point.q.cols();
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(frames * n * (n + 1) / 2 + frames * n * 20));
  const auto add = [&](Index row, Index col, double value) {
    if (held[static_cast<std::size_t>(row)] || held[static_cast<std::size_t>(col)]) value = 0;
    entries.emplace_back(static_cast<int>(row), static_cast<int>(col), value);
  };
  for (Index f = 0; f < frames; ++f) {
    const Eigen::MatrixXd& block = point.models[static_cast<std::size_t>(f)].hessian;
    // Directions without curvature of their own are damped too, or they take wild steps.
    const double floor = 1e-3 * block.diagonal().maxCoeff() + 1e-9;
    for (Index i = 0; i < n; ++i) {
      for (Index j = 0; j <= i; ++j) add(f * n + i, f * n + j, block(i, j));
      const auto row = static_cast<int>(f * n + i);
      const double own =
          held[static_cast<std::size_t>(row)] ? 1.0 : damping * (block(i, i) + floor);
      entries.emplace_back(row, row, own);
    }
  }
  each_difference(problem, [&](Index f, const auto& coefficients, const JointVector& weight) {
    for (std::size_t a = 0; a < coefficients.size(); ++a) {
      for (std::size_t b = 0; b <= a; ++b) {
        const double product = 2 * coefficients[a] * coefficients[b];
        const Index row = (f + static_cast<Index>(a)) * n, col = (f + static_cast<Index>(b)) * n;
        for (Index j = 0; j < n; ++j) add(row + j, col + j, product * weight[j]);
      }
    }
  });
  Sparse hessian(frames * n, frames * n);
  hessian.setFromTriplets(entries.begin(), entries.end());
  return hessian;
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

  // The pattern is the same in every step: analysed once.
  Eigen::SimplicialLDLT<Sparse, Eigen::Lower, Eigen::NaturalOrdering<int>> solver;
  bool analysed = false;
  double damping = 1e-3;
  MovementMinimum result;
  std::vector<bool> held(static_cast<std::size_t>(frames * n));
  for (result.iterations = 0; result.iterations < options.iterations; ++result.iterations) {
    const JointRows g = gradient(problem, now);
    JointVector right_side(frames * n);
    for (Index f = 0; f < frames; ++f) {
      for (Index j = 0; j < n; ++j) {
        const bool at_lower = now.q(f, j) <= problem.lower[j] && g(f, j) > 0;
        const bool at_upper = now.q(f, j) >= problem.upper[j] && g(f, j) < 0;
        held[static_cast<std::size_t>(f * n + j)] = at_lower || at_upper;
        right_side[f * n + j] = at_lower || at_upper ? 0 : -g(f, j);
      }
    }
    const Sparse hessian = damped_hessian(problem, now, held, damping);
    if (!analysed) solver.analyzePattern(hessian);
    analysed = true;
    solver.factorize(hessian);
    const JointVector step = solver.solve(right_side);
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
