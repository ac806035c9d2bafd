#include "core/math/joint_spline.hpp"

#include <algorithm>

namespace morphe::math {
namespace {

using Weights = Eigen::Matrix<double, 4, 6, Eigen::RowMajor>;

/// Weights of the coefficients in a derivative: differences of the B-splines of a lower degree.
template <std::size_t Order>
void spread(Weights& weights, double z, double rate,
            const std::array<double, Order + 1>& difference) {
  const auto lower = bspline_weights<5 - static_cast<int>(Order)>(z);
  for (std::size_t k = 0; k < lower.size(); ++k) {
    for (std::size_t d = 0; d <= Order; ++d) {
      weights(Order, static_cast<Eigen::Index>(k + d)) += lower[k] * difference[d] * rate;
    }
  }
}

}  // namespace

SplinePoint spline_point(const JointSpline& spline, double u) {
  const double knots = std::clamp(u / spline.step(), 0.0, static_cast<double>(spline.intervals));
  const auto interval = std::min(static_cast<Eigen::Index>(knots), spline.intervals - 1);
  return {interval, knots - static_cast<double>(interval)};
}

void evaluate(const JointSpline& spline, double u, JointRows& out) {
  const SplinePoint at = spline_point(spline, u);
  const double rate = 1 / spline.step();
  Weights weights = Weights::Zero();
  spread<0>(weights, at.z, 1, {1});
  spread<1>(weights, at.z, rate, {-1, 1});
  spread<2>(weights, at.z, rate * rate, {1, -2, 1});
  spread<3>(weights, at.z, rate * rate * rate, {-1, 3, -3, 1});
  out.noalias() = weights.lazyProduct(spline.coefficient.middleRows<6>(at.interval));
  out.row(0) += spline.origin;
}

}  // namespace morphe::math
