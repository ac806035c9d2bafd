#include "core/closure/barrier.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>

namespace morphe::closure {
namespace {

/// Computes outer^2 - |inner|^2 without cancellation.
double cone_slack(double outer, double inner) { return (outer - inner) * (outer + inner); }

/// Returns the value of the barrier function, infinity outside the feasible set.
double value(const BarrierProblem& problem, double t, const Eigen::VectorXd& x) {
  constexpr double outside = std::numeric_limits<double>::infinity();
  double sum = t * (0.5 * x.dot(problem.hessian * x) + problem.gradient.dot(x));
  const auto keep_inside = [&](double outer, double inner) {
    const double left = cone_slack(outer, inner);
    sum = outer > 0 && left > 0 && sum < outside ? sum - std::log(left) : outside;
  };
  for (Eigen::Index k = 0; k < problem.cones; ++k) {
    keep_inside(x[4 * k], x.segment<3>(4 * k + 1).norm());
  }
  keep_inside(x[x.size() - 1], (problem.residual_matrix * x + problem.residual_offset).norm());
  const Eigen::VectorXd left = problem.row_bounds - problem.rows * x;
  for (const double slack : left) {
    sum = slack > 0 && sum < outside ? sum - std::log(slack) : outside;
  }
  return sum;
}

/// Gradient and Hessian of -log(outer^2 - |inner|^2) with respect to (outer, inner).
template <int Size>
struct ConeTerm {
  Eigen::Matrix<double, Size, 1> gradient;
  Eigen::Matrix<double, Size, Size> hessian;

  explicit ConeTerm(const Eigen::Matrix<double, Size, 1>& x) {
    const double left = cone_slack(x[0], x.template tail<Size - 1>().norm());
    gradient = 2 / left * x;
    gradient[0] = -gradient[0];
    hessian = gradient * gradient.transpose();
    hessian.diagonal().template tail<Size - 1>().array() += 2 / left;
    hessian(0, 0) = 2 * x.squaredNorm() / (left * left);  // without cancellation
  }
};

/// Computes the Newton step, and in `decrement` twice the decrease that it predicts.
Eigen::VectorXd newton_step(const BarrierProblem& problem, double t, const Eigen::VectorXd& x,
                            double& decrement) {
  const Eigen::Index n = x.size();
  Eigen::MatrixXd hessian = t * problem.hessian;
  Eigen::VectorXd gradient = t * (problem.hessian * x + problem.gradient);
  for (Eigen::Index k = 0; k < problem.cones; ++k) {
    const ConeTerm<4> term(x.segment<4>(4 * k));
    gradient.segment<4>(4 * k) += term.gradient;
    hessian.block<4, 4>(4 * k, 4 * k) += term.hessian;
  }
  // The bound of |A x + b| is the last unknown, for which A has a column of zeros.
  Eigen::MatrixXd chain(7, n);
  chain << Eigen::RowVectorXd::Unit(n, n - 1), problem.residual_matrix;
  Eigen::Matrix<double, 7, 1> rest = chain * x;
  rest.tail<6>() += problem.residual_offset;
  const ConeTerm<7> term(rest);
  gradient += chain.transpose() * term.gradient;
  hessian += chain.transpose() * term.hessian * chain;
  const Eigen::VectorXd inverse = (problem.row_bounds - problem.rows * x).cwiseInverse();
  const Eigen::MatrixXd scaled = inverse.asDiagonal() * problem.rows;
  gradient += problem.rows.transpose() * inverse;
  hessian += scaled.transpose() * scaled;
  // Forces and slacks have different magnitudes, so the unknowns are scaled to a unit diagonal.
  const Eigen::VectorXd unit = hessian.diagonal().cwiseSqrt().cwiseInverse();
  hessian = unit.asDiagonal() * hessian * unit.asDiagonal();
  const Eigen::VectorXd step =
      -unit.cwiseProduct(hessian.ldlt().solve(unit.cwiseProduct(gradient)));
  decrement = -gradient.dot(step);
  return step;
}

}  // namespace

bool minimise_with_barrier(const BarrierProblem& problem, Eigen::VectorXd& x) {
  constexpr double last = 1e6;
  constexpr int most_steps = 50, most_halvings = 40;
  bool settled = true;
  for (double t = 1; t <= last; t *= 10) {
    settled = false;
    for (int k = 0; k < most_steps && !settled; ++k) {
      double decrement = 0;
      const Eigen::VectorXd step = newton_step(problem, t, x, decrement);
      const double before = value(problem, t, x);
      // Decreases below the rounding of the value cannot be achieved.
      settled = std::abs(decrement) <= 1e-2 + 1e-13 * std::abs(before);
      if (settled || !(decrement > 0)) break;
      double length = 1;
      int halvings = 0;
      while (halvings < most_halvings &&
             !(value(problem, t, x + length * step) <= before - 0.1 * length * decrement)) {
        length *= 0.5;
        ++halvings;
      }
      if (halvings == most_halvings) break;
      x += length * step;
    }
  }
  return settled;
}

}  // namespace morphe::closure
