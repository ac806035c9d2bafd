#include "stages/verify/braking.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::verify {
namespace {

constexpr double kBrakingRatioResolution = 1e-6;
constexpr int kMaxBisectionDepth = 40, kMaxBrakingBisections = 2000;

/// Computes the use of the braking curve at a speed towards an end that is `way` away.
BrakingLimitUse braking_limit_use(const RobotModel::BrakingCurve& curve, double speed, double way) {
  const double root = std::sqrt(std::max(curve.twice_deceleration * way, 0.0));
  const double left = std::max(root - curve.velocity_offset, 0.0);
  const double ratio = speed <= 0 ? 0 : left > 0 ? speed / left : HUGE_VAL;
  return {ratio, 0, speed, left};
}

struct Interval {
  double low, high;
};

/// The motion in one direction; the signs are reversed for the lower end.
struct Direction {
  double sign, end;
  Interval interval_of(const Range& range) const {
    return sign > 0 ? Interval{range.least.value, range.greatest.value}
                    : Interval{-range.greatest.value, -range.least.value};
  }
};

/// Returns a bound of |d ratio / dt| over intervals of way, speed and acceleration: with u = root -
/// drop, ratio = v / u and du/dt = -slope v / (2 root).
double max_ratio_rate(const RobotModel::BrakingCurve& curve, const Interval& way,
                      const Interval& speed, const Interval& acceleration) {
  const double root_low = std::sqrt(std::max(curve.twice_deceleration * way.low, 0.0));
  const double root_high = std::sqrt(std::max(curve.twice_deceleration * way.high, 0.0));
  const double low = root_low - curve.velocity_offset, high = root_high - curve.velocity_offset;
  if (!(low > 0) || speed.low < 0) return HUGE_VAL;
  const double falls_low = 0.5 * curve.twice_deceleration * speed.low * speed.low / root_high;
  const double falls_high = 0.5 * curve.twice_deceleration * speed.high * speed.high / root_low;
  const double least = std::min(acceleration.low * low, acceleration.low * high) + falls_low;
  const double most = std::max(acceleration.high * low, acceleration.high * high) + falls_high;
  return std::max(std::abs(least), std::abs(most)) / (low * low);
}

void search(const RobotModel::BrakingCurve& curve, const Quintic& quintic, const Direction& towards,
            double a, double b, int halvings, int& parts, BrakingLimitUse& worst) {
  const double middle = 0.5 * (a + b);
  BrakingLimitUse here =
      braking_limit_use(curve, towards.sign * derivative(quintic, 1, middle),
                        towards.sign * (towards.end - derivative(quintic, 0, middle)));
  here.s = middle;
  if (here.ratio > worst.ratio) worst = here;
  const auto over = ranges(quintic, a, b);
  const Interval q = towards.interval_of(over[0]), speed = towards.interval_of(over[1]);
  const double end = towards.sign * towards.end;
  const Interval distance_to_end{end - q.high, end - q.low};
  const double half_s = 0.5 * (b - a) * quintic.step_s;
  const double bound = std::min(braking_limit_use(curve, speed.high, distance_to_end.low).ratio,
                                here.ratio + half_s * max_ratio_rate(curve, distance_to_end, speed,
                                                                     towards.interval_of(over[2])));
  if (halvings == 0 || !(bound > worst.ratio * (1 + kBrakingRatioResolution))) return;
  if (--parts < 0) {
    worst.ratio = bound;
    return;
  }
  search(curve, quintic, towards, a, middle, halvings - 1, parts, worst);
  search(curve, quintic, towards, middle, b, halvings - 1, parts, worst);
}

}  // namespace

BrakingLimitUse max_braking_use(const RobotModel::BrakingCurve& curve, const Quintic& quintic,
                                double known) {
  BrakingLimitUse worst;
  worst.ratio = known;
  int parts = kMaxBrakingBisections;
  search(curve, quintic, {1, curve.upper_end}, 0, 1, kMaxBisectionDepth, parts, worst);
  search(curve, quintic, {-1, curve.lower_end}, 0, 1, kMaxBisectionDepth, parts, worst);
  return worst;
}

}  // namespace morphe::verify
