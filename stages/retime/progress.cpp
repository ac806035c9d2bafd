#include "stages/retime/progress.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "stages/retime/banded.hpp"

namespace morphe {
namespace {

constexpr double kFastest = 6;  ///< cap on dw/dt, for the ramps, where g' does not bound it
constexpr double kFirstBarrier = 1e-2, kLastBarrier = 3e-6;  ///< share of the duration
constexpr int kNewtonSteps = 60;                             ///< at most, for each barrier
constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Local = Eigen::Vector3d;  ///< of (x, x_w, x_ww) at a collocation point

/// One collocation point: constraints divided by their limits, so that every bound is 1.
struct Point {
  Eigen::Index interval = 0;
  Eigen::Matrix<double, 3, 4> local_from_coefficient;
  double weight = 0;          ///< of x^(-1/2) in the duration
  double ceiling = 0;         ///< x <= ceiling
  Eigen::ArrayXd a0, a1;      ///< acceleration: |a0 x + a1 x_w| <= 1
  Eigen::ArrayXd j0, j1, j2;  ///< jerk: |j0 x + j1 x_w + j2 x_ww| <= x^(-1/2)
};

Eigen::Matrix<double, 3, 4> local_weights(double z, double step) {
  Eigen::Matrix<double, 3, 4> m;
  m.setZero();
  const auto value = bspline_weights<3>(z);
  const auto first = bspline_weights<2>(z);
  const auto second = bspline_weights<1>(z);
  for (Eigen::Index k = 0; k < 4; ++k) m(0, k) = value[static_cast<std::size_t>(k)];
  for (Eigen::Index k = 0; k < 3; ++k) {
    m(1, k) -= first[static_cast<std::size_t>(k)] / step;
    m(1, k + 1) += first[static_cast<std::size_t>(k)] / step;
  }
  for (Eigen::Index k = 0; k < 2; ++k) {
    const double w = second[static_cast<std::size_t>(k)] / (step * step);
    m(2, k) += w;
    m(2, k + 1) -= 2 * w;
    m(2, k + 2) += w;
  }
  return m;
}

struct Bounds {
  double share = 1, tempo_cap = 1;
};

Point point_at(const RobotTable& robot, const RampedPath& path, const ClockedPath& clocked,
               double w, const Bounds& bounds, JointRows& q) {
  const double share = bounds.share;
  evaluate(path, w, q);
  const Eigen::ArrayXd q1 = q.row(1).transpose(), q2 = q.row(2).transpose(),
                       q3 = q.row(3).transpose();
  const Eigen::ArrayXd a = share * robot.acceleration.array(), j = share * robot.jerk.array();
  Point point;
  point.a0 = q2 / a;
  point.a1 = 0.5 * q1 / a;
  point.j0 = q3 / j;
  point.j1 = 1.5 * q2 / j;
  point.j2 = 0.5 * q1 / j;
  const double haste = (q1.abs() / (share * robot.velocity.array())).maxCoeff();
  const ClockAt clock = clock_at(path, w);
  const double tempo = clock.d1 / (bounds.tempo_cap * stretch_at(clocked, clock.u));
  const double slowest = std::max({haste, tempo, 1 / kFastest});
  point.ceiling = 1 / (slowest * slowest);
  return point;
}

Eigen::Index intervals_of(const RampedPath& path, double step_s) {
  return std::max<Eigen::Index>(8, static_cast<Eigen::Index>(std::ceil(path.length / step_s)));
}

std::vector<Point> collocation(const RobotTable& robot, const RampedPath& path,
                               const ClockedPath& clocked, const Bounds& bounds, double step_s) {
  const Eigen::Index intervals = intervals_of(path, step_s);
  const double step = path.length / static_cast<double>(intervals);
  std::vector<Point> points;
  JointRows q;
  for (Eigen::Index i = 0; i < intervals; ++i) {
    for (const double z : {0.0, 0.5, 1.0}) {
      if (z == 1 && i + 1 < intervals) continue;
      const bool end = (i == 0 && z == 0) || z == 1;
      const double w = (static_cast<double>(i) + z) * step;
      Point point = point_at(robot, path, clocked, w, bounds, q);
      point.interval = i;
      point.local_from_coefficient = local_weights(z, step);
      point.weight = (end ? 0.25 : 0.5) * step;
      points.push_back(std::move(point));
    }
  }
  return points;
}

/// Sum of log(slack) over both signs of |value| <= bound; -infinity outside.
double log_slacks(const Eigen::ArrayXd& value, double bound) {
  double sum = 0, product = 1;
  for (Eigen::Index k = 0; k < value.size(); ++k) {
    const double slack = (bound - value[k]) * (bound + value[k]) / (bound * bound);
    if (!(slack > 0)) return -kInfinity;
    product *= slack;
    if (product < 1e-200) {
      sum += std::log(product);
      product = 1;
    }
  }
  return sum + std::log(product);
}

double merit(const std::vector<Point>& points, const Eigen::VectorXd& c, double barrier) {
  double sum = 0, slacks = 0;
  for (const Point& p : points) {
    const Local x = p.local_from_coefficient * c.segment<4>(p.interval);
    if (!(x[0] > 0) || !(x[0] < p.ceiling)) return kInfinity;
    const double pace = 1 / std::sqrt(x[0]);
    sum += p.weight * pace;
    // The bound's own logarithm, log(pace) a joint and sign, belongs to the jerk slack.
    slacks += std::log(1 - x[0] / p.ceiling) + log_slacks(p.a0 * x[0] + p.a1 * x[1], 1) +
              log_slacks(p.j0 * x[0] + p.j1 * x[1] + p.j2 * x[2], pace) +
              2 * static_cast<double>(p.j0.size()) * std::log(pace);
    if (slacks == -kInfinity) return kInfinity;
  }
  return sum - barrier * slacks;
}

/// Gradient and a positive definite approximation of the Hessian of the merit at one point; what
/// the curvature of x^(-1/2) in the jerk bound would subtract is left out.
void local_model(const Point& p, const Local& x, double barrier, Local& gradient,
                 Eigen::Matrix3d& hessian) {
  const double pace = 1 / std::sqrt(x[0]), pace_1 = -0.5 * pace / x[0];
  const double room = p.ceiling - x[0];
  gradient = Local(p.weight * pace_1 + barrier / room, 0, 0);
  hessian.setZero();
  hessian(0, 0) = 0.75 * p.weight * pace / (x[0] * x[0]) + barrier / (room * room);
  for (Eigen::Index k = 0; k < p.a0.size(); ++k) {
    const double value = p.a0[k] * x[0] + p.a1[k] * x[1];
    const double above = 1 / (1 - value), below = 1 / (1 + value);
    const double pull = barrier * (above - below);
    const double stiff = barrier * (above * above + below * below);
    gradient[0] += pull * p.a0[k];
    gradient[1] += pull * p.a1[k];
    hessian(0, 0) += stiff * p.a0[k] * p.a0[k];
    hessian(1, 0) += stiff * p.a0[k] * p.a1[k];
    hessian(1, 1) += stiff * p.a1[k] * p.a1[k];
  }
  for (Eigen::Index k = 0; k < p.j0.size(); ++k) {
    const double value = p.j0[k] * x[0] + p.j1[k] * x[1] + p.j2[k] * x[2];
    for (const double sign : {1.0, -1.0}) {
      const double inverse = 1 / (pace - sign * value);
      const Local normal(sign * p.j0[k] - pace_1, sign * p.j1[k], sign * p.j2[k]);
      gradient += barrier * inverse * normal;
      hessian.noalias() += barrier * inverse * inverse * normal * normal.transpose();
    }
  }
  hessian(0, 1) = hessian(1, 0);
  hessian(0, 2) = hessian(2, 0);
  hessian(1, 2) = hessian(2, 1);
}

/// Newton step of the merit; false if it cannot be computed. decrement = -gradient . step.
bool newton_step(const std::vector<Point>& points, const Eigen::VectorXd& c, double barrier,
                 Eigen::VectorXd& step, double& decrement) {
  BandedMatrix hessian(c.size(), 3);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(c.size());
  Local local_gradient;
  Eigen::Matrix3d local_hessian;
  for (const Point& p : points) {
    const auto& m = p.local_from_coefficient;
    local_model(p, m * c.segment<4>(p.interval), barrier, local_gradient, local_hessian);
    gradient.segment<4>(p.interval) += m.transpose() * local_gradient;
    const Eigen::Matrix4d block = m.transpose() * local_hessian * m;
    for (Eigen::Index a = 0; a < 4; ++a) {
      for (Eigen::Index b = 0; b <= a; ++b) hessian.entry(p.interval + a, a - b) += block(a, b);
    }
  }
  if (!gradient.allFinite() || !factor(hessian)) return false;
  step = -gradient;
  solve_factored(hessian, step);
  decrement = -gradient.dot(step);
  return step.allFinite() && decrement > 0;
}

/// The largest steady dw/dt squared that meets every bound.
double steady_pace(const std::vector<Point>& points) {
  double x = kInfinity;
  for (const Point& p : points) {
    x = std::min(x, p.ceiling);
    if (p.a0.size() == 0) continue;
    x = std::min(x, 1 / std::max(1e-12, p.a0.abs().maxCoeff()));
    x = std::min(x, std::pow(std::max(1e-12, p.j0.abs().maxCoeff()), -2.0 / 3));
  }
  return x;
}

}  // namespace

RampedPath ramp_ends(const JointSpline& spline, double ramp_s) {
  // A ramp covers 0.6 of its length on the clock.
  const double ramp = std::min(ramp_s, spline.length / 1.2);
  return {&spline, ramp, spline.length + 0.8 * ramp};
}

ClockAt clock_at(const RampedPath& path, double w) {
  const bool ending = w > 0.5 * path.length;
  const double from_end = ending ? path.length - w : w;
  const double z = from_end / path.ramp;
  ClockAt at{from_end - 0.4 * path.ramp, 1, 0, 0};
  if (z < 1) {
    at.u = path.ramp * z * z * z * (2 - 2 * z + 0.6 * z * z);
    at.d1 = z * z * (6 - 8 * z + 3 * z * z);
    at.d2 = 12 * z * (1 - z) * (1 - z) / path.ramp;
    at.d3 = 12 * (1 - z) * (1 - 3 * z) / (path.ramp * path.ramp);
  }
  if (ending) {
    at.u = path.spline->length - at.u;
    at.d2 = -at.d2;
  }
  return at;
}

void evaluate(const RampedPath& path, double w, JointRows& out) {
  const ClockAt at = clock_at(path, w);
  evaluate(*path.spline, at.u, out);
  out.row(3) =
      out.row(3) * (at.d1 * at.d1 * at.d1) + out.row(2) * (3 * at.d1 * at.d2) + out.row(1) * at.d3;
  out.row(2) = out.row(2) * (at.d1 * at.d1) + out.row(1) * at.d2;
  out.row(1) *= at.d1;
}

ProgressAt evaluate(const Progress& progress, double w) {
  const Eigen::Index intervals = progress.coefficient.size() - 3;
  const double step = progress.length / static_cast<double>(intervals);
  const double knots = std::clamp(w / step, 0.0, static_cast<double>(intervals));
  const auto interval = std::min(static_cast<Eigen::Index>(knots), intervals - 1);
  const Local x = local_weights(knots - static_cast<double>(interval), step) *
                  progress.coefficient.segment<4>(interval);
  return {x[0], x[1], x[2]};
}

Progress steady_progress(const RobotTable& robot, const RampedPath& path,
                         const ClockedPath& clocked, double share, double tempo_cap,
                         double step_s) {
  const double x = steady_pace(collocation(robot, path, clocked, {share, tempo_cap}, step_s));
  return {path.length, Eigen::VectorXd::Constant(intervals_of(path, step_s) + 3, 0.9 * x)};
}

Progress fastest_progress(const RobotTable& robot, const RampedPath& path,
                          const ClockedPath& clocked, double share, double tempo_cap,
                          double step_s) {
  const std::vector<Point> points = collocation(robot, path, clocked, {share, tempo_cap}, step_s);
  Progress progress{path.length, Eigen::VectorXd::Constant(intervals_of(path, step_s) + 3,
                                                           0.9 * steady_pace(points))};
  Eigen::VectorXd& c = progress.coefficient;
  Eigen::VectorXd step, trial;
  const double each = path.length / static_cast<double>(points.size());
  for (double barrier = kFirstBarrier * each; barrier > kLastBarrier * each; barrier *= 0.2) {
    double now = merit(points, c, barrier);
    for (int newton = 0; newton < kNewtonSteps; ++newton) {
      double decrement = 0;
      if (!newton_step(points, c, barrier, step, decrement)) break;
      double length = 1, then = kInfinity;
      for (; length > 1e-6; length *= 0.5) {
        trial = c + length * step;
        then = merit(points, trial, barrier);
        if (then <= now - 0.05 * length * decrement) break;
      }
      if (!(then < now)) break;
      c = trial;
      now = then;
      if (decrement < 0.1 * barrier * static_cast<double>(points.size())) break;
    }
  }
  return progress;
}

}  // namespace morphe
