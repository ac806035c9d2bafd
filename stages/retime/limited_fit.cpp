#include "stages/retime/limited_fit.hpp"

#include <algorithm>

#include "stages/retime/constants.hpp"

namespace morphe::retime {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Returns an interval's Bézier points from its coefficients: the blossom at k ones, 5 - k zeros.
Matrix6 bezier_from_coefficients() {
  Matrix6 out;
  for (int k = 0; k <= 5; ++k) {
    Matrix6 blossom = Matrix6::Identity();
    for (int level = 1; level <= 5; ++level) {
      const double x = level <= k ? 1 : 0, knots = 6 - level;
      for (int a = 0; a + level <= 5; ++a) {
        const double high = a + 1;
        blossom.row(a) =
            (high - x) / knots * blossom.row(a) + (x - high + knots) / knots * blossom.row(a + 1);
      }
    }
    out.row(k) = blossom.row(0);
  }
  return out;
}

struct BezierPoint {
  Eigen::Index interval = 0, k = 0;
};
BezierPoint bezier_point(Eigen::Index point, Eigen::Index intervals) {
  const Eigen::Index interval = std::min(point / 5, intervals - 1);
  return {interval, point - 5 * interval};
}

/// Updates the multipliers. Returns the largest distance of a Bézier point outside of the limits.
double update_multipliers(const LimitedFit& fit, const Matrix6& bezier,
                          const Eigen::VectorXd& coefficient, LimitMultipliers& pull) {
  const Eigen::Index intervals = coefficient.size() - 5;
  double max_excess = 0;
  for (Eigen::Index point = 0; point <= 5 * intervals; ++point) {
    const BezierPoint location = bezier_point(point, intervals);
    const double value = bezier.row(location.k).dot(coefficient.segment<6>(location.interval));
    max_excess = std::max({max_excess, fit.lower - value, value - fit.upper});
    if (pull.side.size() == 0) {
      if (value >= fit.lower && value <= fit.upper) continue;
      pull.side = pull.shift = Eigen::VectorXd::Zero(5 * intervals + 1);
    }
    double &side = pull.side[point], &shift = pull.shift[point];
    if (side == 0) {
      side = value > fit.upper ? 1 : value < fit.lower ? -1 : 0;
      continue;
    }
    shift += side > 0 ? value - fit.upper : fit.lower - value;
    if (shift < 0) side = shift = 0;
  }
  return max_excess;
}

}  // namespace

void add_form(math::BandedMatrix& normal, Eigen::Index first, double weight, const double* form) {
  for (int a = 0; a < 6; ++a) {
    const double weighted = weight * form[a];
    for (int b = 0; b <= a; ++b) normal.entry(first + a, a - b) += weighted * form[b];
  }
}

math::BandedMatrix factor_damped(const math::BandedMatrix& normal) {
  for (double damping = 1e-10;; damping *= 1e2) {
    math::BandedMatrix damped = normal;
    for (Eigen::Index i = 0; i < damped.size; ++i) damped.entry(i, 0) += damping;
    if (math::factor(damped)) return damped;
  }
}

void solve_within_limits(const LimitedFit& fit, LimitMultipliers& pull, Eigen::VectorXd& solution) {
  const Matrix6 bezier = bezier_from_coefficients();
  const Eigen::Index intervals = solution.size() - 5;
  for (int round = 0; round < kMaxPulls; ++round) {
    // The multipliers of an earlier fit come first: this curve, fitted without, cannot update them.
    const bool earlier = round == 0 && pull.side.size() > 0;
    if (!earlier && update_multipliers(fit, bezier, solution, pull) < 0.5 * kLimitInset_rad) return;
    math::BandedMatrix normal = fit.normal;
    solution = fit.right;
    for (Eigen::Index point = 0; point < pull.side.size(); ++point) {
      const double side = pull.side[point];
      if (side == 0) continue;
      const BezierPoint location = bezier_point(point, intervals);
      const Eigen::Matrix<double, 6, 1> form = bezier.row(location.k);
      const double weight = fit.weight[location.interval];
      const double target = (side > 0 ? fit.upper : fit.lower) - side * pull.shift[point];
      solution.segment<6>(location.interval) += weight * target * form;
      add_form(normal, location.interval, weight, form.data());
    }
    math::solve_factored(factor_damped(normal), solution);
  }
  // Clamping is safe: an interval whose coefficients are inside the limits is inside.
  for (Eigen::Index i = 0; i < intervals; ++i) {
    auto six = solution.segment<6>(i);
    const Eigen::Matrix<double, 6, 1> points = bezier * six;
    if (points.minCoeff() >= fit.lower - 0.5 * kLimitInset_rad &&
        points.maxCoeff() <= fit.upper + 0.5 * kLimitInset_rad)
      continue;
    six = six.cwiseMax(fit.lower).cwiseMin(fit.upper).eval();
  }
}

}  // namespace morphe::retime
