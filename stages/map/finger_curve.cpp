#include "stages/map/finger_curve.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::map {
namespace {

constexpr std::size_t kSpanCount = 3;

/// A cubic spline between knots i and i + 1 at a distance h[i], with the second derivatives at the
/// knots.
struct Spline {
  std::array<Vec3, 4> point, second_derivative;
  std::array<double, kSpanCount> h;

  Vec3 at(std::size_t i, double u) const {
    const double a = 1 - u;
    return a * point[i] + u * point[i + 1] +
           h[i] * h[i] / 6 *
               ((a * a * a - a) * second_derivative[i] +
                (u * u * u - u) * second_derivative[i + 1]);
  }
  /// Returns |d at / d u|.
  double speed(std::size_t i, double u) const {
    const double a = 1 - u;
    return (point[i + 1] - point[i] +
            h[i] * h[i] / 6 *
                ((1 - 3 * a * a) * second_derivative[i] +
                 (3 * u * u - 1) * second_derivative[i + 1]))
        .norm();
  }
  /// Returns the arc length of span i up to u, by Gauss–Legendre quadrature with five points on
  /// each of eight parts.
  double length(std::size_t i, double u) const {
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
  for (std::size_t i = 0; i < kSpanCount; ++i) spline.h[i] = (point[i + 1] - point[i]).norm();
  const auto& h = spline.h;
  const auto slope = [&](std::size_t i) -> Vec3 { return (point[i + 1] - point[i]) / h[i]; };
  const Vec3 r1 = 6 * (slope(1) - slope(0)), r2 = 6 * (slope(2) - slope(1));
  const double d1 = 2 * (h[0] + h[1]), d2 = 2 * (h[1] + h[2]);
  const double determinant = d1 * d2 - h[1] * h[1];
  spline.second_derivative = {Vec3::Zero(), (d2 * r1 - h[1] * r2) / determinant,
                              (d1 * r2 - h[1] * r1) / determinant, Vec3::Zero()};
  return spline;
}

}  // namespace

Vec3 finger_curve_point(const std::array<Vec3, 4>& fingers, double share) {
  if (!std::all_of(fingers.begin(), fingers.end(), [](const Vec3& p) { return is_known(p); })) {
    return unknown_point();
  }
  for (std::size_t i = 0; i < kSpanCount; ++i) {
    if (fingers[i] == fingers[i + 1]) return unknown_point();
  }
  const Spline spline = spline_through(fingers);
  std::array<double, kSpanCount> lengths;
  double whole = 0;
  for (std::size_t i = 0; i < kSpanCount; ++i) whole += lengths[i] = spline.length(i, 1);
  double left = std::clamp(share, 0.0, 1.0) * whole;
  std::size_t span = 0;
  while (span + 1 < kSpanCount && left > lengths[span]) left -= lengths[span++];
  double low = 0, high = 1;
  while (high - low > 1e-10) {
    const double middle = (low + high) / 2;
    (spline.length(span, middle) < left ? low : high) = middle;
  }
  return spline.at(span, (low + high) / 2);
}

}  // namespace morphe::map
