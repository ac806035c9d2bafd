#include "core/solve/trust_region.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <random>

#include "core/solve/minimise.hpp"

namespace morphe::solve {
namespace {

using Eigen::Index;

/// Made by hand: n variables, g·x + ½ xᵀ H x with a known H.
BoundedProblem quadratic_problem(const Eigen::MatrixXd& h, const JointVector& g, double bound) {
  BoundedProblem problem;
  problem.lower = JointVector::Constant(g.size(), -bound);
  problem.upper = JointVector::Constant(g.size(), bound);
  problem.objective = [h, g](const JointVector& x, JointVector* gradient) {
    if (gradient) *gradient = g + h * x;
    return g.dot(x) + 0.5 * x.dot(h * x);
  };
  problem.model = [h, g](const JointVector& x, Quadratic& model) {
    model.value += g.dot(x) + 0.5 * x.dot(h * x);
    model.gradient += g + h * x;
    model.hessian += h;
  };
  return problem;
}

/// An arm of `trunk` joints that carries fingers of three: a finger's joints and the arm's meet, no
/// two fingers do.
Eigen::MatrixXd tree_matrix(Index trunk, Index fingers, std::mt19937_64& random) {
  std::normal_distribution<> normal;
  const Index n = trunk + 3 * fingers;
  Eigen::MatrixXd h = Eigen::MatrixXd::Zero(n, n);
  for (Index f = 0; f < fingers; ++f) {
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(4, n);
    for (Index i = 0; i < 4; ++i) {
      for (Index j = 0; j < trunk; ++j) rows(i, j) = normal(random);
      for (Index j = 0; j < 3; ++j) rows(i, trunk + 3 * f + j) = normal(random);
    }
    h += rows.transpose() * rows;
  }
  h.diagonal().array() += 0.1;
  return h;
}

JointVector random_vector(Index n, std::mt19937_64& random) {
  std::normal_distribution<> normal;
  JointVector v(n);
  for (double& entry : v) entry = normal(random);
  return v;
}

TEST(EnvelopeCholesky, SolvesLikeADenseSolver) {
  std::mt19937_64 random(1);
  for (const Index fingers : {0, 1, 5}) {
    const Index trunk = 7;
    Eigen::MatrixXd h = tree_matrix(trunk, fingers, random);
    const Eigen::MatrixXd whole = h;
    std::vector<char> held(static_cast<std::size_t>(h.rows()), 0);
    held[2] = 1;
    JointVector x = random_vector(h.rows(), random);
    x[2] = 0;
    h.row(2).setZero();
    h.col(2).setZero();
    h.diagonal().array() += 0.5;
    const JointVector expected = h.ldlt().solve(x);
    EnvelopeCholesky factor;
    ASSERT_TRUE(factor.factorise(whole, 0.5, held));
    factor.solve(x);
    EXPECT_LT((x - expected).cwiseAbs().maxCoeff(), 1e-10);
  }
}

TEST(EnvelopeCholesky, SaysHowMuchDampingIsMissing) {
  Eigen::MatrixXd h = Eigen::MatrixXd::Zero(3, 3);
  h.diagonal() << 2, -3, 5;
  const std::vector<char> held(3, 0);
  EnvelopeCholesky factor;
  EXPECT_FALSE(factor.factorise(h, 0, held));
  EXPECT_NEAR(factor.missing_damping, 3, 1e-12);
  EXPECT_TRUE(factor.factorise(h, 3.1, held));
}

TEST(EnvelopeCholesky, SaysAlongWhatTheCurvatureIsNotPositive) {
  std::mt19937_64 random(3);
  Eigen::MatrixXd h = tree_matrix(7, 3, random);
  h(4, 4) = -30;
  std::vector<char> held(static_cast<std::size_t>(h.rows()), 0);
  held[8] = 1;
  EnvelopeCholesky factor;
  ASSERT_FALSE(factor.factorise(h, 0.5, held));
  const JointVector& down = factor.negative_curvature_direction;
  EXPECT_EQ(down[8], 0);
  EXPECT_LT(factor.curvature, 0);
  const double curvature = down.dot(h * down) / down.squaredNorm() + 0.5;
  EXPECT_NEAR(factor.curvature, curvature, 1e-10);
  EXPECT_NEAR(factor.missing_damping, -curvature, 1e-10);
}

/// The minimum inside the bounds is known by its slopes: none inwards on a bound, none elsewhere.
TEST(Structured, BoundedQuadraticsEndWhereNoSlopeLeadsOn) {
  std::mt19937_64 random(2);
  int on_bounds = 0;
  for (int k = 0; k < 200; ++k) {
    const Eigen::MatrixXd h = tree_matrix(7, k % 6, random);
    const JointVector g = 3 * random_vector(h.rows(), random);
    const BoundedProblem problem = quadratic_problem(h, g, 0.3);
    const Minimum found = minimise(problem, 0.1 * random_vector(h.rows(), random), {});
    ASSERT_TRUE(found.converged);
    const JointVector slope = g + h * found.x;
    for (Index j = 0; j < g.size(); ++j) {
      ASSERT_LE(std::abs(found.x[j]), 0.3);
      if (found.x[j] == 0.3) {
        EXPECT_LT(slope[j], 1e-4);
        ++on_bounds;
      } else if (found.x[j] == -0.3) {
        EXPECT_GT(slope[j], -1e-4);
        ++on_bounds;
      } else {
        EXPECT_NEAR(slope[j], 0, 1e-3);
      }
    }
  }
  EXPECT_GT(on_bounds, 500);
}

/// A double well: from its top in y, where the curvature is negative, down into one of the wells.
TEST(Structured, LeavesNegativeCurvature) {
  BoundedProblem problem;
  problem.lower = JointVector::Constant(2, -3);
  problem.upper = JointVector::Constant(2, 3);
  problem.model = [](const JointVector& x, Quadratic& model) {
    const double y = x[1];
    model.value += 50 * x[0] * x[0] + y * y * y * y - 2 * y * y;
    model.gradient += (JointVector(2) << 100 * x[0], 4 * y * y * y - 4 * y).finished();
    model.hessian(0, 0) += 100;
    model.hessian(1, 1) += 12 * y * y - 4;
  };
  const Minimum found = minimise(problem, (JointVector(2) << 1, 0.1).finished(), {});
  EXPECT_NEAR(found.x[0], 0, 1e-6);
  EXPECT_NEAR(found.x[1], 1, 1e-4);
  EXPECT_NEAR(found.value, -1, 1e-8);
}

TEST(Structured, TheSameScratchGivesTheSameBits) {
  std::mt19937_64 random(3);
  TrustRegionScratch scratch;
  for (const Index fingers : {5, 0, 3}) {  // also for other sizes
    const Eigen::MatrixXd h = tree_matrix(7, fingers, random);
    const BoundedProblem problem = quadratic_problem(h, random_vector(h.rows(), random), 0.5);
    const JointVector start = random_vector(h.rows(), random);
    const Minimum fresh = minimise(problem, start, {});
    const Minimum reused = minimise_trust_region(problem, start, {}, scratch);
    EXPECT_EQ(fresh.x, reused.x);
    EXPECT_EQ(fresh.evaluations, reused.evaluations);
  }
}

}  // namespace
}  // namespace morphe::solve
