#include "core/closure/barrier.hpp"

#include <Eigen/Cholesky>
#include <cmath>

#include "core/motion/geometry.hpp"

namespace morphe::closure {
namespace {

/// Computes outer^2 - |inner|^2 without cancellation.
double cone_slack(double outer, double inner) { return (outer - inner) * (outer + inner); }

/// Returns the value of the barrier function, infinity outside the feasible set.
double barrier_value(const BarrierProblem& problem, double t, const Eigen::VectorXd& x) {
  double sum = t * (0.5 * x.dot(problem.hessian * x) + problem.gradient.dot(x));
  const auto add_cone = [&](double outer, double inner) {
    const double slack = cone_slack(outer, inner);
    sum = outer > 0 && slack > 0 && sum < kInfinity ? sum - std::log(slack) : kInfinity;
  };
  for (int k = 0; k < problem.cones; ++k) add_cone(x[4 * k], x.segment<3>(4 * k + 1).norm());
  add_cone(x[x.size() - 1], (problem.residual_matrix * x + problem.residual_offset).norm());
  const Eigen::VectorXd slacks = problem.row_bounds - problem.rows * x;
  for (const double s : slacks) sum = s > 0 && sum < kInfinity ? sum - std::log(s) : kInfinity;
  return sum;
}

/// Gradient and Hessian of -log(outer^2 - |inner|^2) with respect to (outer, inner).
template <int Size>
struct ConeTerm {
  Eigen::Matrix<double, Size, 1> gradient;
  Eigen::Matrix<double, Size, Size> hessian;

  explicit ConeTerm(const Eigen::Matrix<double, Size, 1>& x) {
    const double slack = cone_slack(x[0], x.template tail<Size - 1>().norm());
    gradient = 2 / slack * x;
    gradient[0] = -gradient[0];
    hessian = gradient * gradient.transpose();
    hessian.diagonal().template tail<Size - 1>().array() += 2 / slack;
    hessian(0, 0) = 2 * x.squaredNorm() / (slack * slack);  // without cancellation
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
  Eigen::Matrix<double, 7, 1> residual = chain * x;
  residual.tail<6>() += problem.residual_offset;
  const ConeTerm<7> term(residual);
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
  constexpr double kLastWeight = 1e6;
  constexpr int kMaxSteps = 50, kMaxHalvings = 40;
  bool converged = true;
  for (double t = 1; t <= kLastWeight; t *= 10) {
    converged = false;
    for (int k = 0; k < kMaxSteps && !converged; ++k) {
      double decrement = 0;
      const Eigen::VectorXd step = newton_step(problem, t, x, decrement);
      const double old_value = barrier_value(problem, t, x);
      // A decrease below the rounding of the value cannot be achieved.
      converged = std::abs(decrement) <= 1e-2 + 1e-13 * std::abs(old_value);
      if (converged || !(decrement > 0)) break;
      double length = 1;
      int halvings = 0;
      while (halvings < kMaxHalvings && !(barrier_value(problem, t, x + length * step) <=
                                          old_value - 0.1 * length * decrement)) {
        length *= 0.5;
        ++halvings;
      }
      if (halvings == kMaxHalvings) break;
      x += length * step;
    }
  }
  return converged;
}

}  // namespace morphe::closure
