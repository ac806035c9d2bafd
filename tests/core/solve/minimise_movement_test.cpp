#include "core/solve/minimise_movement.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

namespace morphe::solve {
namespace {

/// Adds ‖residual‖² with its Jacobian [rows, n].
void add_squares(const Eigen::VectorXd& residual, const Eigen::MatrixXd& jacobian,
                 Quadratic& model) {
  model.value += residual.squaredNorm();
  model.gradient += 2 * jacobian.transpose() * residual;
  model.hessian += 2 * jacobian.transpose() * jacobian;
}

using Eigen::Index;

/// F_f = sum_j (q_j - target(f, j))²: with the penalty a linear least-squares problem.
MovementProblem quadratic_problem(const JointRows& target, double weight) {
  MovementProblem problem;
  problem.frames = static_cast<std::size_t>(target.rows());
  problem.lower = JointVector::Constant(target.cols(), -100);
  problem.upper = JointVector::Constant(target.cols(), 100);
  problem.difference_weight = {JointVector::Zero(target.cols()), JointVector::Zero(target.cols()),
                               JointVector::Constant(target.cols(), weight)};
  problem.frame_model = [target](std::size_t f, const JointVector& q, Quadratic& model) {
    const JointVector away = q - target.row(static_cast<Index>(f)).transpose();
    add_squares(away, Eigen::MatrixXd::Identity(q.size(), q.size()), model);
  };
  return problem;
}

JointRows noisy_target(Index frames, Index joints) {
  JointRows target(frames, joints);
  for (Index f = 0; f < frames; ++f) {
    for (Index j = 0; j < joints; ++j) {
      const auto x = static_cast<double>(f * 7 + j * 3);
      target(f, j) = std::sin(0.1 * static_cast<double>(f) + static_cast<double>(j)) +
                     0.2 * std::sin(12.9 * x);
    }
  }
  return target;
}

TEST(MinimiseMovement, SolvesALinearProblemLikeADenseSolver) {
  const JointRows target = noisy_target(30, 3);
  const double weight = 4;
  const MovementMinimum found =
      minimise_movement(quadratic_problem(target, weight), JointRows::Zero(30, 3), {});
  Eigen::MatrixXd difference = Eigen::MatrixXd::Zero(27, 30);
  for (Index f = 0; f < 27; ++f) difference.block(f, f, 1, 4) << -1, 3, -3, 1;
  const Eigen::MatrixXd normal =
      Eigen::MatrixXd::Identity(30, 30) + weight * difference.transpose() * difference;
  const Eigen::MatrixXd expected = normal.ldlt().solve(Eigen::MatrixXd(target));
  EXPECT_LT((Eigen::MatrixXd(found.q) - expected).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_TRUE(found.converged);
}

TEST(MinimiseMovement, EveryOrderOfDifferenceCounts) {
  const JointRows target = noisy_target(25, 1);
  MovementProblem problem = quadratic_problem(target, 0.5);
  problem.difference_weight[0].setConstant(3);
  problem.difference_weight[1].setConstant(2);
  const MovementMinimum found = minimise_movement(problem, JointRows::Zero(25, 1), {});
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(25, 25);
  const Eigen::MatrixXd first = identity.bottomRows(24) - identity.topRows(24);
  const Eigen::MatrixXd second = first.bottomRows(23) - first.topRows(23);
  const Eigen::MatrixXd third = second.bottomRows(22) - second.topRows(22);
  const Eigen::MatrixXd normal = identity + 3 * first.transpose() * first +
                                 2 * second.transpose() * second + 0.5 * third.transpose() * third;
  const Eigen::MatrixXd expected = normal.ldlt().solve(Eigen::MatrixXd(target));
  EXPECT_LT((Eigen::MatrixXd(found.q) - expected).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(MinimiseMovement, BoundsHoldAndTheKktConditionsWithThem) {
  const JointRows target = noisy_target(40, 2);
  MovementProblem problem = quadratic_problem(target, 2);
  problem.lower = JointVector::Constant(2, -0.4);
  problem.upper = JointVector::Constant(2, 0.5);
  const MovementMinimum found = minimise_movement(problem, JointRows::Zero(40, 2), {});
  const auto value = [&](const JointRows& q) {
    double sum = (q - target).squaredNorm();
    for (Index f = 0; f + 3 < 40; ++f) {
      sum += 2 * (q.row(f + 3) - 3 * q.row(f + 2) + 3 * q.row(f + 1) - q.row(f)).squaredNorm();
    }
    return sum;
  };
  EXPECT_NEAR(found.value, value(found.q), 1e-9);
  int on_bound = 0;
  for (Index f = 0; f < 40; ++f) {
    for (Index j = 0; j < 2; ++j) {
      ASSERT_GE(found.q(f, j), -0.4);
      ASSERT_LE(found.q(f, j), 0.5);
      JointRows up = found.q, down = found.q;
      up(f, j) += 1e-6;
      down(f, j) -= 1e-6;
      const double slope = (value(up) - value(down)) / 2e-6;
      if (found.q(f, j) == -0.4) {
        EXPECT_GT(slope, -1e-4);
        ++on_bound;
      } else if (found.q(f, j) == 0.5) {
        EXPECT_LT(slope, 1e-4);
        ++on_bound;
      } else {
        EXPECT_NEAR(slope, 0, 1e-4);
      }
    }
  }
  EXPECT_GT(on_bound, 5);
}

TEST(MinimiseMovement, ConvergesOnACurvedProblem) {
  // F = (x² + y² - 1)² pulls every frame onto the unit circle.
  MovementProblem problem;
  problem.frames = 20;
  problem.lower = JointVector::Constant(2, -3);
  problem.upper = JointVector::Constant(2, 3);
  problem.difference_weight.fill(JointVector::Zero(2));
  problem.difference_weight[2].setConstant(1e-3);
  problem.frame_model = [](std::size_t, const JointVector& q, Quadratic& model) {
    add_squares(Eigen::VectorXd::Constant(1, q.squaredNorm() - 1), 2 * q.transpose(), model);
  };
  JointRows start(20, 2);
  for (Index f = 0; f < 20; ++f) start.row(f) << 2.0, 0.05 * static_cast<double>(f);
  const MovementMinimum found = minimise_movement(problem, start, {});
  for (Index f = 0; f < 20; ++f) EXPECT_NEAR(found.q.row(f).norm(), 1, 1e-3);
}

}  // namespace
}  // namespace morphe::solve
