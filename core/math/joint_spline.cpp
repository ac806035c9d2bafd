#include "core/math/joint_spline.hpp"

#include <algorithm>

namespace morphe::math {
namespace {

using Weights = Eigen::Matrix<double, 4, 6, Eigen::RowMajor>;

/// Adds row `Order` at z: the B-splines of degree 5 - Order, differenced and multiplied by `rate`.
template <int Order>
void add_derivative_weights(Weights& weights, double z, double rate,
                            const std::array<double, Order + 1>& difference) {
  const auto lower = bspline_weights<5 - Order>(z);
  for (int k = 0; k < std::ssize(lower); ++k)
    for (int d = 0; d <= Order; ++d) weights(Order, k + d) += lower[k] * difference[d] * rate;
}

}  // namespace

KnotPosition knot_position(const JointSpline& spline, double u) {
  const double knots =
      std::clamp(u / spline.knot_spacing(), 0.0, static_cast<double>(spline.intervals));
  const auto interval = std::min(static_cast<Eigen::Index>(knots), spline.intervals - 1);
  return {interval, knots - static_cast<double>(interval)};
}

void evaluate(const JointSpline& spline, double u, JointRows& out) {
  const KnotPosition knot = knot_position(spline, u);
  const double rate = 1 / spline.knot_spacing();
  Weights weights = Weights::Zero();
  add_derivative_weights<0>(weights, knot.z, 1, {1});
  add_derivative_weights<1>(weights, knot.z, rate, {-1, 1});
  add_derivative_weights<2>(weights, knot.z, rate * rate, {1, -2, 1});
  add_derivative_weights<3>(weights, knot.z, rate * rate * rate, {-1, 3, -3, 1});
  out.noalias() = weights.lazyProduct(spline.coefficient.middleRows<6>(knot.interval));
  out.row(0) += spline.origin;
}

}  // namespace morphe::math
