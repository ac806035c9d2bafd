#include "stages/verify/quintic.hpp"

#include <cmath>

namespace morphe::verify {
namespace {

/// A quintic or one of its derivatives in s: sum_k c_k s^k.
struct Polynomial {
  std::array<double, 6> c{};
  int degree = 5;

  double operator()(double s) const {
    double sum = c[degree];
    for (int k = degree - 1; k >= 0; --k) sum = sum * s + c[k];
    return sum;
  }
};

Polynomial differentiate(const Polynomial& p) {
  Polynomial d;
  d.degree = p.degree - 1;
  for (int k = 0; k <= d.degree; ++k) d.c[k] = (k + 1) * p.c[k + 1];
  return d;
}

/// Points of an interval in ascending order, including both ends.
struct Knots {
  std::array<double, 6> s{};
  int count = 2;
};

/// Returns the zero of p between a and b, where p is monotone and changes its sign.
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

/// Returns the outer knots and the zeros of p between them; p is monotone from knot to knot.
Knots sign_changes(const Polynomial& p, const Knots& monotone) {
  Knots changes{{monotone.s[0]}, 1};
  for (int i = 1; i < monotone.count; ++i) {
    const double a = monotone.s[i - 1], b = monotone.s[i];
    if (p(a) * p(b) < 0) changes.s[changes.count++] = crossing(p, a, b);
  }
  changes.s[changes.count++] = monotone.s[monotone.count - 1];
  return changes;
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
  // The differences at the end that the parabola from the start leaves to the higher powers.
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
  for (int k = 1; k < 5; ++k) p[k] = differentiate(p[k - 1]);

  std::array<Range, 4> result;
  Knots turning_points{{from, to}};  // the snap, p[4], has no extrema inside because it is linear
  for (int order = 3; order >= 0; --order) {
    turning_points = sign_changes(p[order + 1], turning_points);
    const double scale = 1 / std::pow(quintic.step_s, order);
    Range& range = result[order];
    range.least = range.greatest = {from, p[order](from) * scale};
    for (int i = 1; i < turning_points.count; ++i) {
      const Extreme extreme{turning_points.s[i], p[order](turning_points.s[i]) * scale};
      if (extreme.value < range.least.value) range.least = extreme;
      if (extreme.value > range.greatest.value) range.greatest = extreme;
    }
  }
  return result;
}

}  // namespace morphe::verify
