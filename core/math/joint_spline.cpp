#include "core/math/joint_spline.hpp"

#include <algorithm>

namespace morphe::math {
namespace {

using Weights = Eigen::Matrix<double, 4, 6, Eigen::RowMajor>;

/// Adds the weights of the coefficients in a derivative: differences of the B-splines of a lower
/// degree.
template <std::size_t Order>
void add_derivative_weights(Weights& weights, double z, double rate,
                            const std::array<double, Order + 1>& difference) {
  const auto lower = bspline_weights<5 - static_cast<int>(Order)>(z);
  for (std::size_t k = 0; k < lower.size(); ++k) {
    for (std::size_t d = 0; d <= Order; ++d) {
      weights(Order, k + d) += lower[k] * difference[d] * rate;
    }
  }
}

}  // namespace

KnotPosition knot_position(const JointSpline& spline, double u) {
  const double knots =
      std::clamp(u / spline.knot_spacing(), 0.0, static_cast<double>(spline.intervals));
  const auto interval = std::min(static_cast<Eigen::Index>(knots), spline.intervals - 1);
  return {interval, knots - static_cast<double>(interval)};
}

void evaluate(const JointSpline& spline, double u, JointRows& out) {
  const KnotPosition at = knot_position(spline, u);
  const double rate = 1 / spline.knot_spacing();
  Weights weights = Weights::Zero();
  add_derivative_weights<0>(weights, at.z, 1, {1});
  add_derivative_weights<1>(weights, at.z, rate, {-1, 1});
  add_derivative_weights<2>(weights, at.z, rate * rate, {1, -2, 1});
  add_derivative_weights<3>(weights, at.z, rate * rate * rate, {-1, 3, -3, 1});
  out.noalias() = weights.lazyProduct(spline.coefficient.middleRows<6>(at.interval));
  out.row(0) += spline.origin;
}

}  // namespace morphe::math
