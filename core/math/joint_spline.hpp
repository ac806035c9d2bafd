#pragma once

#include <array>

#include "core/motion/geometry.hpp"

namespace morphe::math {

/// Returns the D + 1 cardinal B-splines of degree D on a knot interval, at z in [0, 1] along it.
template <int Degree>
std::array<double, Degree + 1> bspline_weights(double z) {
  std::array<double, Degree + 1> w{};
  w[0] = 1;
  for (int p = 1; p <= Degree; ++p) {
    for (int k = p; k >= 0; --k) {
      const double left = k > 0 ? (z + p - k) * w[k - 1] : 0;
      const double right = k < p ? (k + 1 - z) * w[k] : 0;
      w[k] = (left + right) / p;
    }
  }
  return w;
}

/// Joint positions over u in [0, duration_s]: a C⁴ quintic B-spline with uniform knots.
struct JointSpline {
  double duration_s = 1;
  Eigen::Index intervals = 1;  ///< number of knot intervals of equal length
  /// [n] [rad]; stored separately, so that a joint that does not move is exactly constant.
  Eigen::RowVectorXd origin;
  JointRows coefficient;  ///< [intervals + 5, n] [rad], relative to the origin
  /// Returns the distance between knots.
  double knot_spacing() const { return duration_s / static_cast<double>(intervals); }
};

/// The position of u among the knots: the interval, and z in [0, 1] within it.
struct KnotPosition {
  Eigen::Index interval = 0;
  double z = 0;
};
/// Returns the position of u, clamped to [0, duration_s], among the knots.
KnotPosition knot_position(const JointSpline& spline, double u);

/// Computes d^order q / du^order for order 0 … 3, as rows of `out` [4, n].
void evaluate(const JointSpline& spline, double u, JointRows& out);

}  // namespace morphe::math
