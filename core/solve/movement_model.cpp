#include "core/solve/movement_model.hpp"

#include <algorithm>
#include <array>

#include "core/solve/band_cholesky.hpp"

namespace morphe::solve {
namespace {

using Eigen::Index;

/// Coefficients of the forward differences of order 1, 2 and 3.
const std::array<std::vector<double>, 3> kDifferences{{{-1, 1}, {1, -2, 1}, {-1, 3, -3, 1}}};

JointVector difference(const JointRows& q, Index f, const std::vector<double>& coefficients) {
  JointVector sum = JointVector::Zero(q.cols());
  for (const double coefficient : coefficients) sum += coefficient * q.row(f++).transpose();
  return sum;
}

/// Calls visit(first frame, coefficients, weight) for every difference of the movement.
template <class Visit>
void each_difference(const MovementProblem& problem, const Visit& visit) {
  for (std::size_t order = 0; order < kDifferences.size(); ++order)
    for (Index f = 0; f + std::ssize(kDifferences[order]) <= problem.frames; ++f)
      visit(f, kDifferences[order], problem.difference_weight[order]);
}

}  // namespace

void evaluate(const MovementProblem& problem, MovementPoint& point) {
  const Index n = point.q.cols();
  point.models.resize(problem.frames);
  point.frame_value = 0;
  JointVector q(n);
  for (Index f = 0; f < problem.frames; ++f) {
    point.models[f].reset(n);
    q = point.q.row(f);
    problem.frame_model(f, q, point.models[f]);
    point.frame_value += point.models[f].value;
  }
  point.value = point.frame_value;
  each_difference(problem, [&](Index f, const auto& coefficients, const JointVector& weight) {
    point.value += difference(point.q, f, coefficients).cwiseAbs2().dot(weight);
  });
}

JointRows gradient(const MovementProblem& problem, const MovementPoint& point) {
  JointRows g(point.q.rows(), point.q.cols());
  for (Index f = 0; f < g.rows(); ++f) g.row(f) = point.models[f].gradient.transpose();
  each_difference(problem, [&](Index f, const auto& coefficients, const JointVector& weight) {
    const JointVector weighted = 2 * difference(point.q, f, coefficients).cwiseProduct(weight);
    for (const double coefficient : coefficients) g.row(f++) += coefficient * weighted.transpose();
  });
  return g;
}

DifferenceCurvature difference_curvature(const MovementProblem& problem) {
  DifferenceCurvature curvature(
      problem.frames, Eigen::MatrixXd::Zero(problem.lower.size(), BandCholesky::kBandBlocks + 1));
  each_difference(problem, [&](Index f, const auto& coefficients, const JointVector& weight) {
    for (Index a = 0; a < std::ssize(coefficients); ++a) {
      for (Index b = 0; b <= a; ++b) {
        curvature[f + a].col(a - b) += 2 * coefficients[a] * coefficients[b] * weight;
      }
    }
  });
  return curvature;
}

JointRows multiply(const DifferenceCurvature& between, const MovementPoint& point,
                   const JointVector& damping, const JointRows& v) {
  JointRows product = damping.asDiagonal() * v;
  for (Index f = 0; f < v.rows(); ++f) {
    product.row(f).noalias() += v.row(f) * point.models[f].hessian;
    product.row(f) += v.row(f).cwiseProduct(between[f].col(0).transpose());
    for (Index before = 1; before <= std::min(f, BandCholesky::kBandBlocks); ++before) {
      const auto weight = between[f].col(before).transpose();
      product.row(f) += v.row(f - before).cwiseProduct(weight);
      product.row(f - before) += v.row(f).cwiseProduct(weight);
    }
  }
  return product;
}

}  // namespace morphe::solve
