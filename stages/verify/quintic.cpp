#include "stages/verify/quintic.hpp"

#include <cmath>
#include <cstddef>

namespace morphe::verify {
namespace {

/// The derivative of some order of the polynomial: d^order/ds^order.
struct Polynomial {
  std::array<double, 6> c{};
  std::size_t degree = 5;

  double operator()(double s) const {
    double sum = c[degree];
    for (std::size_t k = degree; k-- > 0;) sum = sum * s + c[k];
    return sum;
  }
};

Polynomial differentiate(const Polynomial& p) {
  Polynomial d;
  d.degree = p.degree - 1;
  for (std::size_t k = 0; k <= d.degree; ++k) d.c[k] = static_cast<double>(k + 1) * p.c[k + 1];
  return d;
}

/// Points of an interval in ascending order, including both ends.
struct Knots {
  std::array<double, 6> at{};
  std::size_t count = 2;
};

/// Returns the zero of p between a and b, between which p is monotone and changes sign.
double crossing(const Polynomial& p, double a, double b) {
  // A billionth of the interval suffices: the error of the extremum is quadratic in it.
  constexpr int kBisectionCount = 30;
  const bool rising = p(b) > 0;
  for (int i = 0; i < kBisectionCount; ++i) {
    const double middle = 0.5 * (a + b);
    ((p(middle) > 0) == rising ? b : a) = middle;
  }
  return 0.5 * (a + b);
}

/// Returns the ends and the sign changes of p, which is monotone between the given knots.
Knots sign_changes(const Polynomial& p, const Knots& monotone) {
  Knots found;
  found.at[0] = monotone.at[0];
  found.count = 1;
  for (std::size_t i = 0; i + 1 < monotone.count; ++i) {
    const double a = monotone.at[i], b = monotone.at[i + 1];
    if (p(a) * p(b) < 0) found.at[found.count++] = crossing(p, a, b);
  }
  found.at[found.count++] = monotone.at[monotone.count - 1];
  return found;
}

}  // namespace

Quintic quintic_between(double step_s, const JointState& from, const JointState& to) {
  const double h = step_s;
  Quintic quintic;
  quintic.step_s = h;
  auto& c = quintic.c;
  c[0] = from.position;
  c[1] = h * from.velocity;
  c[2] = 0.5 * h * h * from.acceleration;
  // The residuals at the end after the parabola from the start.
  const double position = (to.position - from.position) - c[1] - c[2];
  const double velocity = h * to.velocity - c[1] - 2 * c[2];
  const double half_acceleration = 0.5 * h * h * to.acceleration - c[2];
  c[3] = 10 * position - 4 * velocity + half_acceleration;
  c[4] = -15 * position + 7 * velocity - 2 * half_acceleration;
  c[5] = 6 * position - 3 * velocity + half_acceleration;
  return quintic;
}

double derivative(const Quintic& quintic, int order, double s) {
  Polynomial p{quintic.c, 5};
  for (int k = 0; k < order; ++k) p = differentiate(p);
  return p(s) / std::pow(quintic.step_s, order);
}

std::array<Range, 4> ranges(const Quintic& quintic) { return ranges(quintic, 0, 1); }

std::array<Range, 4> ranges(const Quintic& quintic, double from, double to) {
  std::array<Polynomial, 5> p;
  p[0] = {quintic.c, 5};
  for (std::size_t k = 1; k < p.size(); ++k) p[k] = differentiate(p[k - 1]);

  std::array<Range, 4> found;
  Knots turning{{from, to}};  // the snap, p[4], has no extrema inside because it is linear
  for (std::size_t order = 4; order-- > 0;) {
    turning = sign_changes(p[order + 1], turning);
    const double scale = 1 / std::pow(quintic.step_s, static_cast<double>(order));
    Range& range = found[order];
    range.least = range.greatest = {from, p[order](from) * scale};
    for (std::size_t i = 1; i < turning.count; ++i) {
      const Extreme here{turning.at[i], p[order](turning.at[i]) * scale};
      if (here.value < range.least.value) range.least = here;
      if (here.value > range.greatest.value) range.greatest = here;
    }
  }
  return found;
}

}  // namespace morphe::verify
