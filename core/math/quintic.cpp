#include "core/math/quintic.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::math {
namespace {

/// Up to `degree` points that split an interval into parts on which a polynomial is monotone.
struct MonotoneSplits {
  std::array<double, 6> z{};
  int count = 0;
  void add(double value) { z[count++] = value; }
};

using Polynomial = std::array<double, 6>;  ///< in z, lowest order first

double evaluate(const Polynomial& p, int degree, double z) {
  double value = 0;
  for (int k = degree; k >= 0; --k) value = value * z + p[k];
  return value;
}

Polynomial derivative(const Polynomial& p) {
  Polynomial d{};
  for (int k = 1; k < 6; ++k) d[k - 1] = k * p[k];
  return d;
}

/// Bisects a polynomial that is monotone on [a, b] and changes sign there, down to the resolution.
double bracketed_root(const Polynomial& p, int degree, double a, double b, double a_value) {
  for (int step = 0; step < 80; ++step) {
    const double middle = 0.5 * (a + b);
    if (middle <= a || middle >= b) break;
    const double value = evaluate(p, degree, middle);
    if (value == 0) return middle;
    if ((value < 0) == (a_value < 0))
      a = middle;
    else
      b = middle;
  }
  return 0.5 * (a + b);
}

/// Returns the roots of p in (a, b), given the roots of its derivative there.
MonotoneSplits roots_between(const Polynomial& p, int degree, const MonotoneSplits& cuts, double a,
                             double b) {
  MonotoneSplits roots;
  double left = a, left_value = evaluate(p, degree, a);
  for (int i = 0; i <= cuts.count; ++i) {
    const double right = i < cuts.count ? cuts.z[i] : b;
    const double right_value = evaluate(p, degree, right);
    if (left_value * right_value < 0) roots.add(bracketed_root(p, degree, left, right, left_value));
    left = right;
    left_value = right_value;
  }
  return roots;
}

Range range_over(const Polynomial& p, int degree, const MonotoneSplits& cuts, double a, double b) {
  const double a_value = evaluate(p, degree, a), b_value = evaluate(p, degree, b);
  Range range{std::min(a_value, b_value), std::max(a_value, b_value)};
  for (int i = 0; i < cuts.count; ++i) {
    const double value = evaluate(p, degree, cuts.z[i]);
    range.least = std::min(range.least, value);
    range.greatest = std::max(range.greatest, value);
  }
  return range;
}

/// Computes the ranges of p and its first three derivatives (in z) over [a, b]. Beginning with the
/// jerk, the roots of each derivative split the interval at the extremes of the next lower one.
std::array<Range, 4> ranges(const Polynomial& p, double a, double b) {
  std::array<Polynomial, 5> d{p, derivative(p)};
  for (int k = 2; k < 5; ++k) d[k] = derivative(d[k - 1]);
  std::array<Range, 4> out;
  MonotoneSplits cuts = roots_between(d[4], 1, MonotoneSplits{}, a, b);
  for (int k = 3; k >= 0; --k) {
    out[k] = range_over(d[k], 5 - k, cuts, a, b);
    if (k > 0) cuts = roots_between(d[k], 5 - k, cuts, a, b);
  }
  return out;
}

Range scaled(const Range& range, double factor) {
  return {range.least * factor, range.greatest * factor};
}

JointState state_at(const Trajectory& trajectory, Eigen::Index sample, Eigen::Index joint) {
  return {trajectory.position(sample, joint), trajectory.velocity(sample, joint),
          trajectory.acceleration(sample, joint)};
}

/// Returns the smallest and largest Bézier point of a polynomial on [0, 1]; its values are between.
Range bezier_range(Polynomial b) {
  constexpr int kDegree = 5;
  double factor = 1;  // 1 / C(kDegree, k)
  for (int k = 0; k <= kDegree; ++k) {
    b[k] *= factor;
    factor *= (k + 1.0) / std::max(1, kDegree - k);
  }
  for (int round = 1; round <= kDegree; ++round)
    for (int k = kDegree; k >= round; --k) b[k] += b[k - 1];
  const auto [least, greatest] = std::ranges::minmax(b);
  return {least, greatest};
}

template <class... Values>
Range range_of(double first, Values... others) {
  Range range{first, first};
  ((range.least = std::min(range.least, others)), ...);
  ((range.greatest = std::max(range.greatest, others)), ...);
  return range;
}

template <class... Values>
double max_magnitude(Values... values) {
  double greatest = 0;
  ((greatest = std::max(greatest, std::abs(values))), ...);
  return greatest;
}

}  // namespace

QuinticPiece quintic_piece(const JointState& begin, const JointState& end, double duration) {
  const double v0 = begin.velocity * duration, v1 = end.velocity * duration;
  const double a0 = begin.acceleration * duration * duration;
  const double a1 = end.acceleration * duration * duration;
  const double distance = end.position - begin.position;
  QuinticPiece piece;
  piece.duration = duration;
  piece.coefficient = {begin.position,
                       v0,
                       0.5 * a0,
                       10 * distance - 6 * v0 - 4 * v1 - 1.5 * a0 + 0.5 * a1,
                       -15 * distance + 8 * v0 + 7 * v1 + 1.5 * a0 - a1,
                       6 * distance - 3 * (v0 + v1) + 0.5 * (a1 - a0)};
  return piece;
}

QuinticPiece quintic_piece(const Trajectory& trajectory, Eigen::Index sample, Eigen::Index joint) {
  return quintic_piece(state_at(trajectory, sample, joint), state_at(trajectory, sample + 1, joint),
                       trajectory.time[sample + 1] - trajectory.time[sample]);
}

QuinticPiece cubic_piece(const Trajectory& trajectory, Eigen::Index sample, Eigen::Index joint) {
  QuinticPiece piece;
  piece.duration = trajectory.time[sample + 1] - trajectory.time[sample];
  const JointState begin = state_at(trajectory, sample, joint);
  const JointState end = state_at(trajectory, sample + 1, joint);
  const double distance = end.position - begin.position;
  const double v0 = begin.velocity * piece.duration, v1 = end.velocity * piece.duration;
  piece.coefficient = {begin.position,         v0, 3 * distance - 2 * v0 - v1,
                       v0 + v1 - 2 * distance, 0,  0};
  return piece;
}

double value_at(const QuinticPiece& piece, double t, int order) {
  Polynomial p = piece.coefficient;
  for (int k = 0; k < order; ++k) p = derivative(p);
  return evaluate(p, 5 - order, t / piece.duration) / std::pow(piece.duration, order);
}

QuinticExtremes extremes(const QuinticPiece& piece) { return extremes(piece, 0, piece.duration); }

QuinticExtremes extremes(const QuinticPiece& piece, double from_s, double to_s) {
  const auto over = ranges(piece.coefficient, from_s / piece.duration, to_s / piece.duration);
  const double rate = 1 / piece.duration;
  return {over[0], scaled(over[1], rate), scaled(over[2], rate * rate),
          scaled(over[3], rate * rate * rate)};
}

void enclose(const Trajectory& trajectory, Eigen::Index sample, Enclosure& enclosure) {
  const Eigen::Index joints = trajectory.position.cols();
  for (Eigen::ArrayXd* bound : {&enclosure.lowest, &enclosure.highest, &enclosure.velocity,
                                &enclosure.acceleration, &enclosure.jerk})
    bound->resize(joints);
  const double h = trajectory.time[sample + 1] - trajectory.time[sample];
  const double *q = &trajectory.position(sample, 0), *next_q = &trajectory.position(sample + 1, 0);
  const double *v = &trajectory.velocity(sample, 0), *next_v = &trajectory.velocity(sample + 1, 0);
  const double *a = &trajectory.acceleration(sample, 0),
               *next_a = &trajectory.acceleration(sample + 1, 0);
  for (Eigen::Index j = 0; j < joints; ++j) {
    // The Bézier points of a derivative are differences of those of the next lower one; the mean of
    // the velocity's is the distance divided by the duration.
    const double v0 = v[j], v1 = v0 + h / 4 * a[j], v4 = next_v[j], v3 = v4 - h / 4 * next_a[j];
    const double v2 = 5 / h * (next_q[j] - q[j]) - (v0 + v1 + v3 + v4);
    const double a0 = a[j], a1 = 4 / h * (v2 - v1), a2 = 4 / h * (v3 - v2), a3 = next_a[j];
    const double q1 = q[j] + h / 5 * v0, q2 = q1 + h / 5 * v1;
    const double q4 = next_q[j] - h / 5 * v4, q3 = q4 - h / 5 * v3;
    const auto [lowest, highest] = range_of(q[j], q1, q2, q3, q4, next_q[j]);
    enclosure.lowest[j] = lowest;
    enclosure.highest[j] = highest;
    enclosure.velocity[j] = max_magnitude(v0, v1, v2, v3, v4);
    enclosure.acceleration[j] = max_magnitude(a0, a1, a2, a3);
    enclosure.jerk[j] = 3 / h * max_magnitude(a1 - a0, a2 - a1, a3 - a2);
  }
}

double limit_excess(const QuinticPiece& piece, double lower, double upper) {
  const Range bounds = bezier_range(piece.coefficient);
  if (bounds.least >= lower && bounds.greatest <= upper) return 0;
  const Range position = extremes(piece).position;
  return std::max({0.0, lower - position.least, position.greatest - upper});
}

}  // namespace morphe::math
