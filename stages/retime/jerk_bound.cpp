#include "stages/retime/jerk_bound.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/banded.hpp"
#include "stages/retime/constants.hpp"

namespace morphe::retime {
namespace {

using Local = Eigen::Vector3d;  ///< (x, x_w, x_ww) at a point
using FromCoefficients = Eigen::Matrix<double, 3, 4>;
using Lanes = Eigen::Array<double, 4, 1>;
using LaneRows = Eigen::Map<const Lanes, Eigen::Aligned16>;

/// A point at which constraints hold. There are more near the ends, where q_w and q_ww vanish and
/// leave x_ww free.
struct Point {
  Eigen::Index interval = 0;
  double w = 0, weight = 0;  ///< weight of x^(-1/2) in the duration
  FromCoefficients local;    ///< maps the interval's coefficients to `Local`
};

/// Constraints over their limits, a column per point and a row per joint, with zeros to whole
/// lanes:
///   |a0 x + a1 x_w| <= 1,  |j0 x + j1 x_w + j2 x_ww| x^(1/2) <= 1,  x <= ceiling.
struct Constraints {
  std::vector<Point> point;
  Eigen::ArrayXXd a0, a1, j0, j1, j2;
  Eigen::ArrayXd ceiling;
  Eigen::Index size() const { return ceiling.size(); }
};

FromCoefficients local_from_coefficients(double z, double step) {
  FromCoefficients m = FromCoefficients::Zero();
  const auto value = math::bspline_weights<3>(z);
  const auto first = math::bspline_weights<2>(z);
  const auto second = math::bspline_weights<1>(z);
  for (int k = 0; k < 4; ++k) m(0, k) = value[k];
  for (int k = 0; k < 3; ++k) {
    m(1, k) -= first[k] / step;
    m(1, k + 1) += first[k] / step;
  }
  for (int k = 0; k < 2; ++k)
    m.row(2).segment<3>(k) += second[k] / (step * step) * Eigen::RowVector3d(1, -2, 1);
  return m;
}

std::vector<Point> points_of(double length, Eigen::Index intervals) {
  const double step = length / static_cast<double>(intervals);
  std::vector<Point> points;
  for (int i = 0; i < intervals; ++i) {
    const int parts = i < kEndIntervals || i >= intervals - kEndIntervals ? 4 : 2;
    for (int part = 0; part < parts + (i + 1 == intervals); ++part) {
      const double z = static_cast<double>(part) / parts;
      points.push_back({i, (i + z) * step, 0, local_from_coefficients(z, step)});
    }
  }
  for (int k = 0; k + 1 < std::ssize(points); ++k) {
    const double half = 0.5 * (points[k + 1].w - points[k].w);
    points[k].weight += half;
    points[k + 1].weight += half;
  }
  return points;
}

Constraints constraints_of(const ConstrainedPath& path, const RampedParameter& clock,
                           Eigen::Index intervals, double max_rate) {
  Constraints c;
  c.point = points_of(clock.length, intervals);
  const Eigen::Index points = std::ssize(c.point), n = path.acceleration.size();
  const Eigen::Index rows = (n + 3) / 4 * 4;
  for (Eigen::ArrayXXd* block : {&c.a0, &c.a1, &c.j0, &c.j1, &c.j2}) block->setZero(rows, points);
  c.ceiling.resize(points);
  const Eigen::ArrayXd per_a = path.acceleration.array().inverse();
  const Eigen::ArrayXd per_j = path.jerk.array().inverse();
  JointRows q;
  for (Eigen::Index i = 0; i < points; ++i) {
    const ParameterDerivatives g = clock_at(clock, c.point[i].w);
    math::evaluate(path.spline, g.u, q);
    const double rate = std::min(max_rate, max_path_velocity(path, g.u, q) / std::max(g.d1, 1e-12));
    c.ceiling[i] = rate * rate;
    apply_chain_rule(g, q);
    const double s = slowdown_at(path, g.u);
    const auto column = [&](Eigen::Index order, const Eigen::ArrayXd& per) {
      return q.row(order).transpose().array() * per;
    };
    c.a0.col(i).head(n) = s * s * column(2, per_a);
    c.a1.col(i).head(n) = 0.5 * s * s * column(1, per_a);
    c.j0.col(i).head(n) = s * s * s * column(3, per_j);
    c.j1.col(i).head(n) = 1.5 * s * s * s * column(2, per_j);
    c.j2.col(i).head(n) = 0.5 * s * s * s * column(1, per_j);
  }
  return c;
}

/// Returns duration - barrier * sum of log(1 - value^2); infinite outside of the feasible set.
double merit(const Constraints& c, const Eigen::VectorXd& coefficient, double barrier) {
  double duration = 0, slacks = 0;
  for (Eigen::Index i = 0; i < c.size(); ++i) {
    const Point& point = c.point[i];
    const Local x = point.local * coefficient.segment<4>(point.interval);
    const double gap = 1 - x[0] / c.ceiling[i];
    if (!(x[0] > 0) || !(gap > 0)) return kInfinity;
    const double pace = std::sqrt(x[0]);
    Lanes product = Lanes::Ones(), min_slack = product;
    for (Eigen::Index k = 0; k < c.a0.rows(); k += 4) {
      const LaneRows a0(&c.a0(k, i)), a1(&c.a1(k, i));
      const LaneRows j0(&c.j0(k, i)), j1(&c.j1(k, i)), j2(&c.j2(k, i));
      const Lanes a = 1 - (a0 * x[0] + a1 * x[1]).square();
      const Lanes j = 1 - ((j0 * x[0] + j1 * x[1] + j2 * x[2]) * pace).square();
      min_slack = min_slack.min(a).min(j);
      product *= a * j;
    }
    if (!(min_slack.minCoeff() > 0)) return kInfinity;
    duration += point.weight / pace;
    slacks += std::log(gap) + std::log(product[0] * product[1]) + std::log(product[2] * product[3]);
  }
  return duration - barrier * slacks;
}

struct Newton {
  Eigen::VectorXd gradient, step;
  math::BandedMatrix hessian{0, 3};
};

/// Gradient and Hessian of -log(1 - v^2) over v = d . x, accumulated over lanes.
struct Sums {
  Lanes g0 = Lanes::Zero(), g1 = g0, g2 = g0;
  Lanes h00 = g0, h01 = g0, h02 = g0, h11 = g0, h12 = g0, h22 = g0;
};

/// Computes gradient and Hessian of the merit at a point, without the curvature of value x^(1/2).
void local_model(const Constraints& c, Eigen::Index i, double weight, const Local& x,
                 double barrier, Local& gradient, Eigen::Matrix3d& hessian) {
  Sums s;
  const double pace = std::sqrt(x[0]), bend = 0.5 / x[0];
  for (Eigen::Index k = 0; k < c.a0.rows(); k += 4) {
    const LaneRows a0(&c.a0(k, i)), a1(&c.a1(k, i));
    const Lanes v = a0 * x[0] + a1 * x[1], inverse = (1 - v.square()).inverse();
    const Lanes pull = 2 * v * inverse, stiff = 2 * (1 + v.square()) * inverse.square();
    s.g0 += pull * a0;
    s.g1 += pull * a1;
    s.h00 += stiff * a0 * a0;
    s.h01 += stiff * a0 * a1;
    s.h11 += stiff * a1 * a1;
  }
  for (Eigen::Index k = 0; k < c.a0.rows(); k += 4) {
    const LaneRows j0(&c.j0(k, i)), j1(&c.j1(k, i)), j2(&c.j2(k, i));
    const Lanes v = (j0 * x[0] + j1 * x[1] + j2 * x[2]) * pace;
    const Lanes inverse = (1 - v.square()).inverse();
    const Lanes pull = 2 * v * inverse, stiff = 2 * (1 + v.square()) * inverse.square();
    const Lanes d0 = j0 * pace + v * bend, d1 = j1 * pace, d2 = j2 * pace;
    s.g0 += pull * d0;
    s.g1 += pull * d1;
    s.g2 += pull * d2;
    s.h00 += stiff * d0 * d0;
    s.h01 += stiff * d0 * d1;
    s.h02 += stiff * d0 * d2;
    s.h11 += stiff * d1 * d1;
    s.h12 += stiff * d1 * d2;
    s.h22 += stiff * d2 * d2;
  }
  const double room = c.ceiling[i] - x[0], cost = weight / pace;
  gradient = barrier * Local(s.g0.sum() + 1 / room, s.g1.sum(), s.g2.sum());
  gradient[0] -= bend * cost;
  hessian << s.h00.sum() + 1 / (room * room), s.h01.sum(), s.h02.sum(), s.h01.sum(), s.h11.sum(),
      s.h12.sum(), s.h02.sum(), s.h12.sum(), s.h22.sum();
  hessian *= barrier;
  hessian(0, 0) += 3 * bend * bend * cost;
}

/// Computes the Newton step of the merit, with decrement = -gradient . step; false without a step.
bool newton_step(const Constraints& c, const Eigen::VectorXd& coefficient, double barrier,
                 Newton& newton, double& decrement) {
  newton.hessian = math::BandedMatrix(coefficient.size(), 3);
  newton.gradient.setZero(coefficient.size());
  Local gradient;
  Eigen::Matrix3d hessian;
  for (Eigen::Index i = 0; i < c.size(); ++i) {
    const Point& point = c.point[i];
    const FromCoefficients& m = point.local;
    local_model(c, i, point.weight, m * coefficient.segment<4>(point.interval), barrier, gradient,
                hessian);
    newton.gradient.segment<4>(point.interval) += m.transpose() * gradient;
    const Eigen::Matrix4d block = m.transpose() * hessian * m;
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b <= a; ++b) newton.hessian.entry(point.interval + a, a - b) += block(a, b);
  }
  if (!newton.gradient.allFinite() || !math::factor(newton.hessian)) return false;
  newton.step = -newton.gradient;
  math::solve_factored(newton.hessian, newton.step);
  decrement = -newton.gradient.dot(newton.step);
  return newton.step.allFinite() && decrement > 0;
}

/// Returns for each value a function of the values at most `radius` away.
template <class Function>
Eigen::VectorXd map_windows(const Eigen::VectorXd& values, Eigen::Index radius, Function function) {
  Eigen::VectorXd out(values.size());
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const Eigen::Index from = std::max<Eigen::Index>(0, i - radius);
    out[i] = function(values.segment(from, std::min(values.size(), i + radius + 1) - from));
  }
  return out;
}

/// Returns coefficients that satisfy every bound. They begin as the largest constant x that each
/// point allows, take its minimum and then its mean over a window, and are reduced until all bounds
/// hold.
Eigen::VectorXd feasible_start(const Constraints& c, Eigen::Index intervals) {
  Eigen::VectorXd local = Eigen::VectorXd::Constant(intervals + 3, c.ceiling.maxCoeff());
  for (Eigen::Index i = 0; i < c.size(); ++i) {
    const double a = std::max(1e-12, c.a0.col(i).abs().maxCoeff());
    const double j = std::max(1e-12, c.j0.col(i).abs().maxCoeff());
    const double square = kStartRatio * std::min({c.ceiling[i], 1 / a, std::pow(j, -2.0 / 3)});
    auto coefficients = local.segment<4>(c.point[i].interval);
    coefficients = coefficients.cwiseMin(square);
  }
  Eigen::VectorXd start = map_windows(local, 3 * kStartWindowKnots,
                                      [](const auto& window) { return window.minCoeff(); });
  for (int pass = 0; pass < 3; ++pass)
    start = map_windows(start, kStartWindowKnots, [](const auto& window) { return window.mean(); });
  for (double ratio = 1; ratio > kMinStartRatio; ratio *= kStartReductionRatio)
    if (merit(c, ratio * start, 0) < kInfinity) return ratio * start;
  return Eigen::VectorXd::Constant(intervals + 3, local.minCoeff());
}

void minimise(const Constraints& c, double scale_s, Eigen::VectorXd& coefficient) {
  Newton newton;
  Eigen::VectorXd trial;
  const double point_duration_s = scale_s / static_cast<double>(c.size());
  for (double share = kInitialBarrierShare; share > 0.99 * kFinalBarrierShare;
       share *= kBarrierReductionRatio) {
    const double barrier = share * point_duration_s;
    double merit_value = merit(c, coefficient, barrier);
    for (int k = 0; k < kBarrierSteps; ++k) {
      double decrement = 0;
      if (!newton_step(c, coefficient, barrier, newton, decrement)) break;
      double trial_value = kInfinity;
      for (double length = 1; length > kMinStepLength; length *= 0.5) {
        trial = coefficient + length * newton.step;
        trial_value = merit(c, trial, barrier);
        if (trial_value <= merit_value - kMinDecreaseShare * length * decrement) break;
      }
      if (!(trial_value < merit_value)) break;
      coefficient = trial;
      merit_value = trial_value;
      if (decrement < kConvergedDecrementShare * barrier * static_cast<double>(c.size())) break;
    }
  }
}

bool is_positive(const SquaredVelocity& progress) {
  const Eigen::Index cells = 8 * (progress.coefficient.size() - 3);
  for (int i = 0; i < cells; ++i) {
    const double w = i / static_cast<double>(cells) * progress.length;
    if (!(squared_velocity_at(progress, w) > 0)) return false;
  }
  return true;
}

}  // namespace

SquaredVelocity fastest_squared_velocity(const ConstrainedPath& path, const RampedParameter& clock,
                                         Eigen::Index intervals, double max_rate, double scale_s) {
  const Constraints constraints = constraints_of(path, clock, intervals, max_rate);
  const SquaredVelocity start{clock.length, feasible_start(constraints, intervals)};
  SquaredVelocity fastest = start;
  minimise(constraints, scale_s, fastest.coefficient);
  return is_positive(fastest) ? fastest : start;
}

}  // namespace morphe::retime
