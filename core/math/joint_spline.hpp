#pragma once

#include <array>

#include "core/motion/geometry.hpp"

namespace morphe::math {

/// Weights of the D + 1 cardinal B-splines of degree D that are not zero on one knot interval, at
/// z in [0, 1] of it.
template <int Degree>
std::array<double, Degree + 1> bspline_weights(double z) {
  std::array<double, Degree + 1> w{};
  w[0] = 1;
  for (int p = 1; p <= Degree; ++p) {
    for (int k = p; k >= 0; --k) {
      const auto i = static_cast<std::size_t>(k);
      const double left = k > 0 ? (z + p - k) * w[i - 1] : 0;
      const double right = k < p ? (k + 1 - z) * w[i] : 0;
      w[i] = (left + right) / p;
    }
  }
  return w;
}

/// Joint positions over a clock u in [0, length]: a quintic B-spline on uniform knots (C^4).
struct JointSpline {
  double length = 1;           ///< [s]
  Eigen::Index intervals = 1;  ///< knots are length / intervals apart
  Eigen::RowVectorXd
      origin;             ///< [n] [rad]; apart, so that a joint that stands still does so exactly
  JointRows coefficient;  ///< [intervals + 5, n] [rad], from the origin
  double step() const { return length / static_cast<double>(intervals); }
};

/// Where a clock time lies among the knots: the interval, and z in [0, 1] of it.
struct SplinePoint {
  Eigen::Index interval = 0;
  double z = 0;
};
SplinePoint spline_point(const JointSpline& spline, double u);

/// d^order q / du^order for order 0 … 3, rows of `out` [4, n].
void evaluate(const JointSpline& spline, double u, JointRows& out);

}  // namespace morphe::math
