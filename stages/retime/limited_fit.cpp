#include "stages/retime/limited_fit.hpp"

#include <algorithm>

namespace morphe::retime {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr int kMaxPulls = 20;

/// Returns the matrix that maps the six coefficients on which a knot interval depends to its Bézier
/// points: the blossom at k ones and 5 - k zeros.
Matrix6 bezier_from_coefficients() {
  Matrix6 out;
  for (Eigen::Index k = 0; k <= 5; ++k) {
    Matrix6 blossom = Matrix6::Identity();
    for (Eigen::Index level = 1; level <= 5; ++level) {
      const double x = level <= k ? 1 : 0;
      const auto knots = static_cast<double>(6 - level);
      for (Eigen::Index a = 0; a + level <= 5; ++a) {
        const double high = static_cast<double>(a + 1);
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

/// Returns the distance of the worst Bézier point outside of [lower, upper] and updates the
/// multipliers.
double update_multipliers(const LimitedFit& fit, const Matrix6& bezier,
                          const Eigen::VectorXd& coefficient, LimitMultipliers& pull) {
  const Eigen::Index intervals = coefficient.size() - 5;
  double worst = 0;
  for (Eigen::Index point = 0; point <= 5 * intervals; ++point) {
    const BezierPoint at = bezier_point(point, intervals);
    const double value = bezier.row(at.k).dot(coefficient.segment<6>(at.interval));
    worst = std::max({worst, fit.lower - value, value - fit.upper});
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
  return worst;
}

}  // namespace

void add_form(math::BandedMatrix& normal, Eigen::Index first, double weight, const double* form) {
  for (Eigen::Index a = 0; a < 6; ++a) {
    const double weighted = weight * form[a];
    for (Eigen::Index b = 0; b <= a; ++b) normal.entry(first + a, a - b) += weighted * form[b];
  }
}

math::BandedMatrix factor_damped(const math::BandedMatrix& normal) {
  for (double damping = 1e-10;; damping *= 1e2) {
    math::BandedMatrix damped = normal;
    for (Eigen::Index i = 0; i < damped.size; ++i) damped.entry(i, 0) += damping;
    if (math::factor(damped)) return damped;
  }
}

void solve_within_limits(const LimitedFit& fit, LimitMultipliers& pull,
                         Eigen::VectorXd& coefficient) {
  const Matrix6 bezier = bezier_from_coefficients();
  const Eigen::Index intervals = coefficient.size() - 5;
  for (int round = 0; round < kMaxPulls; ++round) {
    // The multipliers of an earlier fit are applied first, because this curve was fitted without
    // them and cannot update them.
    if (round > 0 || pull.side.size() == 0) {
      if (update_multipliers(fit, bezier, coefficient, pull) < 0.5 * kLimitInset_rad) return;
    }
    math::BandedMatrix normal = fit.normal;
    coefficient = fit.right;
    for (Eigen::Index point = 0; point < pull.side.size(); ++point) {
      const double side = pull.side[point];
      if (side == 0) continue;
      const BezierPoint at = bezier_point(point, intervals);
      const Eigen::Matrix<double, 6, 1> form = bezier.row(at.k);
      const double weight = fit.weight[at.interval];
      const double target = (side > 0 ? fit.upper : fit.lower) - side * pull.shift[point];
      coefficient.segment<6>(at.interval) += weight * target * form;
      add_form(normal, at.interval, weight, form.data());
    }
    math::solve_factored(factor_damped(normal), coefficient);
  }
  // An interval whose coefficients are inside is inside.
  for (Eigen::Index i = 0; i < intervals; ++i) {
    auto six = coefficient.segment<6>(i);
    const Eigen::Matrix<double, 6, 1> points = bezier * six;
    if (points.minCoeff() >= fit.lower - 0.5 * kLimitInset_rad &&
        points.maxCoeff() <= fit.upper + 0.5 * kLimitInset_rad) {
      continue;
    }
    six = six.cwiseMax(fit.lower).cwiseMin(fit.upper).eval();
  }
}

}  // namespace morphe::retime
