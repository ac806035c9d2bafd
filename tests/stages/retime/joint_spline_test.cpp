#include "stages/retime/joint_spline.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "stages/retime/banded.hpp"

namespace morphe {
namespace {

TEST(Banded, SolvesLikeADenseMatrix) {
  BandedMatrix banded(9, 2);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(9, 9);
  for (Eigen::Index i = 0; i < 9; ++i) {
    for (Eigen::Index d = 0; d <= std::min<Eigen::Index>(2, i); ++d) {
      const double value =
          d == 0 ? 4 + 0.1 * static_cast<double>(i) : std::sin(static_cast<double>(3 * i + d));
      banded.entry(i, d) = dense(i, i - d) = dense(i - d, i) = value;
    }
  }
  const Eigen::VectorXd truth = Eigen::VectorXd::LinSpaced(9, -1, 2);
  Eigen::VectorXd x = dense * truth;
  ASSERT_TRUE(factor(banded));
  solve_factored(banded, x);
  EXPECT_LT((x - truth).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Banded, RefusesAnIndefiniteMatrix) {
  BandedMatrix banded(2, 1);
  banded.entry(0, 0) = banded.entry(1, 0) = 1;
  banded.entry(1, 1) = 2;
  EXPECT_FALSE(factor(banded));
}

TEST(JointSpline, DerivativesOfASine) {
  std::vector<double> clock;
  JointRows y(201, 1);
  for (int i = 0; i <= 200; ++i) {
    clock.push_back(0.005 * i);
    y(i, 0) = std::sin(4 * clock.back());
  }
  const std::vector<SmoothingAt> exact(clock.size(), {0, 1e-9});
  const JointVector lower = JointVector::Constant(1, -2), upper = JointVector::Constant(1, 2);
  const JointSpline spline = fit_spline(clock, y, exact, lower, upper, 0.01);
  EXPECT_LT(deviation(spline, clock, y), 1e-8);
  JointRows q;
  for (double u = 0.1; u < 0.9; u += 0.0137) {
    evaluate(spline, u, q);
    EXPECT_NEAR(q(0, 0), std::sin(4 * u), 1e-8);
    EXPECT_NEAR(q(1, 0), 4 * std::cos(4 * u), 1e-5);
    EXPECT_NEAR(q(2, 0), -16 * std::sin(4 * u), 1e-3);
    EXPECT_NEAR(q(3, 0), -64 * std::cos(4 * u), 0.1);
  }
}

TEST(JointSpline, StaysWithinLimits) {
  std::vector<double> clock;
  JointRows y(101, 1);
  for (int i = 0; i <= 100; ++i) {
    clock.push_back(0.01 * i);
    y(i, 0) = std::min(0.5, 0.8 * clock.back());
  }
  const std::vector<SmoothingAt> smooth(clock.size(), {0.03, 1e-3});
  const JointVector lower = JointVector::Constant(1, 0), upper = JointVector::Constant(1, 0.5);
  const JointSpline spline = fit_spline(clock, y, smooth, lower, upper, 0.01);
  EXPECT_LT(deviation(spline, clock, y), 1.3e-3);
  JointRows q;
  for (double u = 0; u <= 1; u += 0.0013) {
    evaluate(spline, u, q);
    EXPECT_LE(q(0, 0), 0.5);
    EXPECT_GE(q(0, 0), 0.0);
  }
}

}  // namespace
}  // namespace morphe
