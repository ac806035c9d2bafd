#pragma once

#include <array>
#include <vector>

#include "pipeline/motion/geometry.hpp"

namespace morphe {

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
  JointRows coefficient;       ///< [intervals + 5, n] [rad]
  double step() const { return length / static_cast<double>(intervals); }
};

/// d^order q / du^order for order 0 … 3, rows of `out` [4, n].
void evaluate(const JointSpline& spline, double u, JointRows& out);

/// What a fit may do at one sample.
struct SmoothingAt {
  double duration = 0.02;   ///< features shorter than about this are smoothed away … [s]
  double tolerance = 1e-3;  ///< … unless that moves the sample by more than this [rad]
};

/// Minimises sum_i w_i |q(u_i) - y_i|^2 + sum (duration/step)^6 |third difference|^2 for each
/// joint, with the weights of samples off by more than their tolerance raised until they are not
/// (or 30 rounds). Stays within [lower, upper] everywhere: a B-spline lies between its
/// coefficients. clock [W] not decreasing, from 0; samples [W, n]; smoothing [W].
JointSpline fit_spline(const std::vector<double>& clock, const JointRows& samples,
                       const std::vector<SmoothingAt>& smoothing, const JointVector& lower,
                       const JointVector& upper, double step_s);

/// Largest |q_j(u_i) - y_ij| [rad].
double deviation(const JointSpline& spline, const std::vector<double>& clock,
                 const JointRows& samples);

}  // namespace morphe
