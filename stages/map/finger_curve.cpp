#include "stages/map/finger_curve.hpp"

#include <algorithm>

namespace morphe::map {
namespace {

constexpr int kSpanCount = 3;

/// A cubic spline through four points, its parameter u from 0 to 1 in spans of the lengths h.
struct Spline {
  std::array<Vec3, 4> point, second_derivative;
  std::array<double, kSpanCount> h;

  Vec3 position(int i, double u) const {
    const double a = 1 - u;
    return a * point[i] + u * point[i + 1] +
           h[i] * h[i] / 6 *
               ((a * a * a - a) * second_derivative[i] +
                (u * u * u - u) * second_derivative[i + 1]);
  }
  /// Returns |d position / d u|.
  double speed(int i, double u) const {
    const double a = 1 - u;
    return (point[i + 1] - point[i] +
            h[i] * h[i] / 6 *
                ((1 - 3 * a * a) * second_derivative[i] +
                 (3 * u * u - 1) * second_derivative[i + 1]))
        .norm();
  }
  /// Returns the arc length of span i up to u (Gauss–Legendre quadrature, five points per part).
  double length(int i, double u) const {
    constexpr int kParts = 8;
    constexpr double kNodes[] = {0, 0.5384693101056831, 0.9061798459386640};
    constexpr double kWeights[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
    double sum = 0;
    const double half = u / (2 * kParts);
    for (int part = 0; part < kParts; ++part) {
      const double middle = (2 * part + 1) * half;
      sum += kWeights[0] * speed(i, middle);
      for (int k = 1; k < 3; ++k) {
        sum += kWeights[k] *
               (speed(i, middle - half * kNodes[k]) + speed(i, middle + half * kNodes[k]));
      }
    }
    return sum * half;
  }
};

/// Returns the natural spline: its second derivatives at the ends are zero.
Spline spline_through(const std::array<Vec3, 4>& point) {
  Spline spline{point, {}, {}};
  for (int i = 0; i < kSpanCount; ++i) spline.h[i] = (point[i + 1] - point[i]).norm();
  const auto& h = spline.h;
  const auto slope = [&](int i) -> Vec3 { return (point[i + 1] - point[i]) / h[i]; };
  const Vec3 r1 = 6 * (slope(1) - slope(0)), r2 = 6 * (slope(2) - slope(1));
  const double d1 = 2 * (h[0] + h[1]), d2 = 2 * (h[1] + h[2]);
  const double determinant = d1 * d2 - h[1] * h[1];
  spline.second_derivative = {Vec3::Zero(), (d2 * r1 - h[1] * r2) / determinant,
                              (d1 * r2 - h[1] * r1) / determinant, Vec3::Zero()};
  return spline;
}

}  // namespace

Vec3 finger_curve_point(const std::array<Vec3, 4>& fingers, double share) {
  if (!std::ranges::all_of(fingers, [](const Vec3& point) { return is_known(point); }) ||
      std::ranges::adjacent_find(fingers) != fingers.end()) {
    return unknown_point();
  }
  const Spline spline = spline_through(fingers);
  std::array<double, kSpanCount> lengths;
  double total = 0;
  for (int i = 0; i < kSpanCount; ++i) total += lengths[i] = spline.length(i, 1);
  double remaining = std::clamp(share, 0.0, 1.0) * total;
  int span = 0;
  while (span + 1 < kSpanCount && remaining > lengths[span]) remaining -= lengths[span++];
  double low = 0, high = 1;
  while (high - low > 1e-10) {
    const double middle = (low + high) / 2;
    (spline.length(span, middle) < remaining ? low : high) = middle;
  }
  return spline.position(span, (low + high) / 2);
}

}  // namespace morphe::map
