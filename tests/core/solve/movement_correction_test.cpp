#include "core/solve/movement_correction.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/solve/minimise_movement.hpp"

namespace morphe::solve {
namespace {

constexpr double kNotSeen = std::numeric_limits<double>::quiet_NaN();

MovementProblem one_frame(std::function<void(const JointVector&, Quadratic&)> model) {
  MovementProblem problem;
  problem.frames = 1;
  problem.lower = JointVector::Constant(2, -2);
  problem.upper = JointVector::Constant(2, 2);
  problem.difference_weight.fill(JointVector::Zero(2));
  problem.frame_model = [model = std::move(model)](std::size_t, const JointVector& q,
                                                   Quadratic& out) { model(q, out); };
  return problem;
}

/// q'Hq / 2 + b'q.
MovementProblem quadratic(const Eigen::Matrix2d& hessian, const Eigen::Vector2d& slope) {
  return one_frame([=](const JointVector& q, Quadratic& model) {
    model.value += 0.5 * q.dot(hessian * q) + slope.dot(q);
    model.gradient += hessian * q + slope;
    model.hessian += hessian;
  });
}

/// 1e4 (q_2 - q_1²)² + (q_1 - 1)², by least squares.
MovementProblem curved_valley() {
  return one_frame([](const JointVector& q, Quadratic& model) {
    const double off = 100 * (q[1] - q[0] * q[0]), along = q[0] - 1;
    const Eigen::Vector2d slope(-200 * q[0], 100);
    model.value += off * off + along * along;
    model.gradient += 2 * off * slope + 2 * along * Eigen::Vector2d::UnitX();
    model.hessian += 2 * slope * slope.transpose();
    model.hessian(0, 0) += 2;
  });
}

JointRows row(double first, double second) {
  JointRows q(1, 2);
  q << first, second;
  return q;
}

MovementPoint at(const MovementProblem& problem, const JointRows& q) {
  MovementPoint point;
  point.q = q;
  evaluate(problem, point);
  return point;
}

JointRows corrected(const MovementProblem& problem, const MovementPoint& from,
                    const JointRows& aimed, const MovementPoint& to, double damping = 0) {
  JointRows q = row(kNotSeen, kNotSeen);
  correct_step(problem, difference_curvature(problem), from, aimed, to,
               JointVector::Constant(1, damping), q);
  return q;
}

TEST(MovementCorrection, AQuadraticsStepIsRightAndStays) {
  const MovementProblem problem = quadratic((Eigen::Matrix2d() << 30, 4, 4, 2).finished(), {1, -3});
  const MovementPoint from = at(problem, row(0.3, -0.2)), to = at(problem, row(-0.7, 1.1));
  EXPECT_NEAR(model_error(from, to.q, to)[0], 0, 1e-12);
  EXPECT_LT((corrected(problem, from, to.q, to) - to.q).norm(), 1e-14);
}

TEST(MovementCorrection, OfAQuadraticItLeadsBackWhereTheStepAimed) {
  const MovementProblem problem = quadratic(Eigen::Vector2d(4e6, 4e6).asDiagonal(), {1, -3});
  const MovementPoint from = at(problem, row(0.3, -0.2)), to = at(problem, row(1, 1));
  const JointRows aimed = row(0.5, 0.4);
  EXPECT_LT((corrected(problem, from, aimed, to) - aimed).norm(), 1e-5);
  // By how much higher the value is than where the step aimed.
  EXPECT_NEAR(model_error(from, aimed, to)[0], to.value - at(problem, aimed).value,
              1e-8 * to.value);
  // Damped as strongly as it is curved, half of the way.
  EXPECT_LT((corrected(problem, from, aimed, to, 4e6) - row(0.75, 0.7)).norm(), 1e-5);
}

TEST(MovementCorrection, NeighboursHoldAFrameBack) {
  MovementProblem problem = quadratic(Eigen::Vector2d(4e6, 4e6).asDiagonal(), {0, 0});
  problem.frames = 2;
  problem.difference_weight[0].setConstant(2e6);  // (q_2 - q_1)²: the curvature of each frame again
  JointRows start(2, 2), aimed(2, 2), end(2, 2), halfway(2, 2);
  start << 0, 0, 0, 0;
  aimed << 0.2, 0.4, -0.4, 0.6;
  end << 0.4, 0, -0.2, 1;
  halfway = 0.5 * (aimed + end);
  const MovementPoint from = at(problem, start), to = at(problem, end);
  JointRows q;
  correct_step(problem, difference_curvature(problem), from, aimed, to, JointVector::Zero(2), q);
  EXPECT_LT((q - halfway).norm(), 1e-5);
}

TEST(MovementCorrection, WhereLittleIsCurvedAndOnBoundsNothingMoves) {
  const MovementProblem problem = quadratic(Eigen::Vector2d(4e6, 0.01).asDiagonal(), {0, 0});
  const MovementPoint from = at(problem, row(0, 0)), to = at(problem, row(1, 1));
  EXPECT_LT((corrected(problem, from, row(0, 0), to) - row(0, 1)).norm(), 1.1e-3);
  const MovementPoint bound = at(problem, row(2, 1));
  EXPECT_EQ(corrected(problem, from, row(0, 0), bound)(0, 0), 2);
}

TEST(MovementCorrection, AStepAlongACurvedValleyReturnsToItsFloor) {
  const MovementProblem problem = curved_valley();
  const MovementPoint from = at(problem, row(0, 0));
  const JointRows aimed = row(1, 0);  // the model's minimum
  MovementPoint to = at(problem, aimed);
  EXPECT_NEAR(from.value, 1, 1e-12);
  EXPECT_NEAR(to.value, 1e4, 1e-8);
  EXPECT_NEAR(model_error(from, aimed, to)[0], 1e4, 1e-8);
  // Along off's slope (-200, 100) over the other curvature (12, 10), until off, -100, is none.
  to = at(problem, corrected(problem, from, aimed, to));
  EXPECT_LT((to.q - row(8. / 13, 3. / 13)).norm(), 1e-3);
  to = at(problem, corrected(problem, from, aimed, to));
  EXPECT_LT(to.value, 0.65);
}

TEST(MovementCorrection, AWholeSearchFollowsACurvedValleyInFewSteps) {
  const MovementMinimum found =
      minimise_movement(curved_valley(), row(-1, 1), {.max_iterations = 25});
  EXPECT_LT(found.value, 1e-4);
}

}  // namespace
}  // namespace morphe::solve
