#include "core/math/quintic.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/braking.hpp"

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
  for (std::size_t k = 1; k < 6; ++k) d[k - 1] = static_cast<double>(k) * p[k];
  return d;
}

/// Returns the root of a polynomial that is monotone on [a, b] and changes sign there, by bisection
/// down to the floating-point resolution.
double bracketed_root(const Polynomial& p, int degree, double a, double b, double at_a) {
  for (int step = 0; step < 80; ++step) {
    const double middle = 0.5 * (a + b);
    if (middle <= a || middle >= b) break;
    const double value = evaluate(p, degree, middle);
    if (value == 0) return middle;
    if ((value < 0) == (at_a < 0)) {
      a = middle;
    } else {
      b = middle;
    }
  }
  return 0.5 * (a + b);
}

/// Returns the roots of p in (a, b), given the roots of its derivative there.
MonotoneSplits roots_between(const Polynomial& p, int degree, const MonotoneSplits& turning,
                             double a, double b) {
  MonotoneSplits roots;
  double left = a, at_left = evaluate(p, degree, a);
  for (int i = 0; i <= turning.count; ++i) {
    const double right = i < turning.count ? turning.z[i] : b;
    const double at_right = evaluate(p, degree, right);
    if (at_left * at_right < 0) roots.add(bracketed_root(p, degree, left, right, at_left));
    left = right;
    at_left = at_right;
  }
  return roots;
}

Range range_over(const Polynomial& p, int degree, const MonotoneSplits& turning, double a,
                 double b) {
  const double at_a = evaluate(p, degree, a), at_b = evaluate(p, degree, b);
  Range range{std::min(at_a, at_b), std::max(at_a, at_b)};
  for (int i = 0; i < turning.count; ++i) {
    const double value = evaluate(p, degree, turning.z[i]);
    range.least = std::min(range.least, value);
    range.greatest = std::max(range.greatest, value);
  }
  return range;
}

/// Computes the ranges of p and its first three derivatives (in z) over [a, b]. Beginning with the
/// jerk, the roots of each derivative split the interval at the extremes of the next lower one.
std::array<Range, 4> ranges(const Polynomial& p, double a, double b) {
  std::array<Polynomial, 5> d{p, derivative(p)};
  for (std::size_t k = 2; k < 5; ++k) d[k] = derivative(d[k - 1]);
  std::array<Range, 4> out;
  MonotoneSplits turning = roots_between(d[4], 1, MonotoneSplits{}, a, b);
  for (std::size_t k = 4; k-- > 0;) {
    const int degree = 5 - static_cast<int>(k);
    out[k] = range_over(d[k], degree, turning, a, b);
    if (k > 0) turning = roots_between(d[k], degree, turning, a, b);
  }
  return out;
}

Range scaled(const Range& range, double factor) {
  return {range.least * factor, range.greatest * factor};
}

JointState state_at(const Trajectory& trajectory, std::size_t sample, Eigen::Index joint) {
  const auto row = static_cast<Eigen::Index>(sample);
  return {trajectory.position(row, joint), trajectory.velocity(row, joint),
          trajectory.acceleration(row, joint)};
}

void update_use(LimitUse& use, double ratio, std::size_t sample, Eigen::Index joint) {
  // The comparison is written such that NaN counts as exceeding the limit.
  if (use.sample >= 0 && ratio <= use.ratio) return;
  use = {ratio, static_cast<int>(sample), static_cast<int>(joint)};
}

void update_use(LimitUse& use, const Range& range, double limit, std::size_t sample,
                Eigen::Index joint) {
  update_use(use, std::max(-range.least, range.greatest) / limit, sample, joint);
}

/// Returns the smallest and largest Bézier point of a polynomial on [0, 1] from its power
/// coefficients.
template <std::size_t N>
Range bezier_range(std::array<double, N> b) {
  constexpr std::size_t degree = N - 1;
  double share = 1;  // 1 / C(degree, k)
  for (std::size_t k = 0; k <= degree; ++k) {
    b[k] *= share;
    share *= static_cast<double>(k + 1) / static_cast<double>(std::max<std::size_t>(1, degree - k));
  }
  for (std::size_t round = 1; round <= degree; ++round) {
    for (std::size_t k = degree; k >= round; --k) b[k] += b[k - 1];
  }
  const auto [least, greatest] = std::minmax_element(b.begin(), b.end());
  return {*least, *greatest};
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
  const double way = end.position - begin.position;
  QuinticPiece piece;
  piece.duration = duration;
  piece.coefficient = {begin.position,
                       v0,
                       0.5 * a0,
                       10 * way - 6 * v0 - 4 * v1 - 1.5 * a0 + 0.5 * a1,
                       -15 * way + 8 * v0 + 7 * v1 + 1.5 * a0 - a1,
                       6 * way - 3 * (v0 + v1) + 0.5 * (a1 - a0)};
  return piece;
}

QuinticPiece quintic_piece(const Trajectory& trajectory, std::size_t sample, Eigen::Index joint) {
  return quintic_piece(state_at(trajectory, sample, joint), state_at(trajectory, sample + 1, joint),
                       trajectory.time[sample + 1] - trajectory.time[sample]);
}

double value_at(const QuinticPiece& piece, double t, int order) {
  Polynomial p = piece.coefficient;
  for (int k = 0; k < order; ++k) p = derivative(p);
  return evaluate(p, 5 - order, t / piece.duration) / std::pow(piece.duration, order);
}

QuinticExtremes extremes(const QuinticPiece& piece) { return extremes(piece, 0, piece.duration); }

QuinticExtremes extremes(const QuinticPiece& piece, double from_s, double to_s) {
  const std::array<Range, 4> over =
      ranges(piece.coefficient, from_s / piece.duration, to_s / piece.duration);
  const double rate = 1 / piece.duration;
  return {over[0], scaled(over[1], rate), scaled(over[2], rate * rate),
          scaled(over[3], rate * rate * rate)};
}

void enclose(const Trajectory& trajectory, std::size_t sample, Enclosure& enclosure) {
  const auto row = static_cast<Eigen::Index>(sample);
  const Eigen::Index joints = trajectory.position.cols();
  for (Eigen::ArrayXd* bound : {&enclosure.lowest, &enclosure.highest, &enclosure.velocity,
                                &enclosure.acceleration, &enclosure.jerk}) {
    bound->resize(joints);
  }
  const double h = trajectory.time[sample + 1] - trajectory.time[sample];
  const double *q = &trajectory.position(row, 0), *next_q = &trajectory.position(row + 1, 0);
  const double *v = &trajectory.velocity(row, 0), *next_v = &trajectory.velocity(row + 1, 0);
  const double *a = &trajectory.acceleration(row, 0),
               *next_a = &trajectory.acceleration(row + 1, 0);
  for (Eigen::Index j = 0; j < joints; ++j) {
    // The points of each derivative are differences of those of the next lower one; the mean of the
    // velocity points is the distance divided by the duration.
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

LimitReport limit_report(const RobotModel& robot, const Trajectory& trajectory) {
  LimitReport report;
  Enclosure within;
  const auto holds = [](const LimitUse& use, double value, double limit) {
    return use.sample >= 0 && value <= use.ratio * limit;
  };
  for (std::size_t sample = 0; sample + 1 < trajectory.samples(); ++sample) {
    enclose(trajectory, sample, within);
    for (Eigen::Index joint = 0; joint < trajectory.position.cols(); ++joint) {
      const double room = std::min(within.lowest[joint] - robot.lower[joint],
                                   robot.upper[joint] - within.highest[joint]);
      if (report.margin_sample >= 0 && room >= report.position_margin &&
          holds(report.velocity, within.velocity[joint], robot.velocity[joint]) &&
          holds(report.acceleration, within.acceleration[joint], robot.acceleration[joint]) &&
          holds(report.jerk, within.jerk[joint], robot.jerk[joint]) &&
          std::ranges::find(robot.braking_curves, joint, &RobotModel::BrakingCurve::joint) ==
              robot.braking_curves.end()) {
        continue;  // no bound of this joint exceeds the maxima so far
      }
      const QuinticPiece piece = quintic_piece(trajectory, sample, joint);
      const QuinticExtremes over = extremes(piece);
      update_use(report.velocity, over.velocity, robot.velocity[joint], sample, joint);
      update_use(report.acceleration, over.acceleration, robot.acceleration[joint], sample, joint);
      update_use(report.jerk, over.jerk, robot.jerk[joint], sample, joint);
      for (const RobotModel::BrakingCurve& curve : robot.braking_curves) {
        if (curve.joint != joint) continue;
        update_use(report.velocity, braking_ratio(curve, piece, report.velocity.ratio), sample,
                   joint);
      }
      const double margin = std::min(over.position.least - robot.lower[joint],
                                     robot.upper[joint] - over.position.greatest);
      if (report.margin_sample >= 0 && margin >= report.position_margin) continue;
      report.position_margin = margin;
      report.margin_sample = static_cast<int>(sample);
      report.margin_joint = static_cast<int>(joint);
    }
  }
  return report;
}

}  // namespace morphe::math
