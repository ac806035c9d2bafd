#include "core/math/joint_spline.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math/banded.hpp"

namespace morphe::math {
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
  JointRows both(9, 2);
  both << x, -2 * x;
  ASSERT_TRUE(factor(banded));
  solve_factored(banded, x);
  EXPECT_LT((x - truth).cwiseAbs().maxCoeff(), 1e-12);
  solve_factored(banded, both);
  EXPECT_LT((both.col(1) + 2 * truth).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Banded, RefusesAnIndefiniteMatrix) {
  BandedMatrix banded(2, 1);
  banded.entry(0, 0) = banded.entry(1, 0) = 1;
  banded.entry(1, 1) = 2;
  EXPECT_FALSE(factor(banded));
}

TEST(JointSpline, DerivativesAreThoseOfItsPositions) {
  JointSpline spline{0.7, 9, Eigen::RowVectorXd::Constant(2, 0.3), JointRows(14, 2)};
  for (Eigen::Index i = 0; i < 14; ++i) {
    spline.coefficient.row(i) << std::sin(1.3 * static_cast<double>(i)),
        std::cos(0.7 * static_cast<double>(i * i));
  }
  constexpr double kStep = 1e-4;
  JointRows before, at, after;
  for (double u = 0.01; u < 0.69; u += 0.0137) {
    evaluate(spline, u - kStep, before);
    evaluate(spline, u, at);
    evaluate(spline, u + kStep, after);
    for (Eigen::Index order = 0; order < 3; ++order) {
      const Eigen::RowVectorXd slope = (after.row(order) - before.row(order)) / (2 * kStep);
      const double scale = 1 + at.row(order + 1).cwiseAbs().maxCoeff();
      EXPECT_LT((slope - at.row(order + 1)).cwiseAbs().maxCoeff(), 1e-3 * scale);
    }
  }
}

}  // namespace
}  // namespace morphe::math
