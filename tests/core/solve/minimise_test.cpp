#include "core/solve/minimise.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace morphe::solve {
namespace {

/// Rosenbrock's valley; the minimum (1, 1) is known.
double rosenbrock(const JointVector& x, JointVector* gradient) {
  const double a = 1 - x[0], b = x[1] - x[0] * x[0];
  if (gradient) *gradient = (JointVector(2) << -2 * a - 400 * x[0] * b, 200 * b).finished();
  return a * a + 100 * b * b;
}

void rosenbrock_model(const JointVector& x, Quadratic& model) {
  JointVector gradient;
  model.value += rosenbrock(x, &gradient);
  model.gradient += gradient;
  model.hessian(0, 0) += 2 - 400 * (x[1] - 3 * x[0] * x[0]);
  model.hessian(1, 0) += -400 * x[0];
  model.hessian(0, 1) += -400 * x[0];
  model.hessian(1, 1) += 200;
}

class Minimise : public testing::TestWithParam<const char*> {};

TEST_P(Minimise, FindsTheMinimumInsideTheBounds) {
  MinimiseOptions options;
  options.algorithm = GetParam();
  options.max_evaluations = 2000;
  const BoundedProblem problem{JointVector::Constant(2, -2), JointVector::Constant(2, 2),
                               rosenbrock, rosenbrock_model};
  const Minimum found = minimise(problem, (JointVector(2) << -1.2, 1).finished(), options);
  EXPECT_NEAR(found.x[0], 1, 1e-4);
  EXPECT_NEAR(found.x[1], 1, 2e-4);
}

TEST_P(Minimise, StopsOnTheBoundThatCutsTheMinimumOff) {
  // With x0 <= 0.5 the best is x0 = 0.5, x1 = 0.25, F = 0.25.
  MinimiseOptions options;
  options.algorithm = GetParam();
  options.max_evaluations = 2000;
  BoundedProblem problem{JointVector::Constant(2, -2), JointVector::Constant(2, 2), rosenbrock,
                         rosenbrock_model};
  problem.upper[0] = 0.5;
  const Minimum found = minimise(problem, (JointVector(2) << -1.2, 1).finished(), options);
  EXPECT_LE(found.x[0], 0.5);
  EXPECT_NEAR(found.value, 0.25, 1e-5);
}

TEST_P(Minimise, ReturnsTheBestPointWhenCutShort) {
  MinimiseOptions options;
  options.algorithm = GetParam();
  options.max_evaluations = 7;
  const BoundedProblem problem{JointVector::Constant(2, -2), JointVector::Constant(2, 2),
                               rosenbrock, rosenbrock_model};
  const JointVector start = (JointVector(2) << -1.2, 1).finished();
  const Minimum found = minimise(problem, start, options);
  EXPECT_LE(found.value, rosenbrock(start, nullptr));
  EXPECT_DOUBLE_EQ(found.value, rosenbrock(found.x, nullptr));
}

INSTANTIATE_TEST_SUITE_P(Algorithms, Minimise,
                         testing::Values("trust_region", "tnewton", "slsqp", "lbfgs"));

TEST(MinimiseOptions, RefusesAnUnknownAlgorithm) {
  MinimiseOptions options;
  options.algorithm = "simplex";
  EXPECT_NE(validation_error(options).find("simplex"), std::string::npos);
}

}  // namespace
}  // namespace morphe::solve
