#include "stages/verify/braking.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::verify {
namespace {

constexpr double kBrakingRatioResolution = 1e-6;
constexpr int kMaxBisectionDepth = 40, kMaxBrakingBisections = 2000;

/// Returns the use of the curve by a joint that moves towards an end of its range at a distance.
BrakingLimitUse braking_limit_use(const RobotModel::BrakingCurve& curve, double speed,
                                  double distance) {
  const double root = std::sqrt(std::max(curve.twice_deceleration * distance, 0.0));
  const double allowed = std::max(root - curve.velocity_offset, 0.0);
  const double ratio = speed <= 0 ? 0 : allowed > 0 ? speed / allowed : HUGE_VAL;
  return {ratio, 0, speed, allowed};
}

struct Interval {
  double low, high;
};

/// The end of the joint's range that it moves towards; signs are reversed for the lower end.
struct Direction {
  double sign, end;
  Interval interval_of(const Range& range) const {
    return sign > 0 ? Interval{range.least.value, range.greatest.value}
                    : Interval{-range.greatest.value, -range.least.value};
  }
};

/// Returns a bound of |d ratio / dt| over intervals of distance, speed v and acceleration a,
/// infinite if u may be 0 or v negative: with root = sqrt(twice_deceleration distance) and u = root
/// - velocity_offset, the rate is (a u + twice_deceleration v^2 / (2 root)) / u^2.
double max_ratio_rate(const RobotModel::BrakingCurve& curve, const Interval& distance,
                      const Interval& speed, const Interval& acceleration) {
  const double root_low = std::sqrt(std::max(curve.twice_deceleration * distance.low, 0.0));
  const double root_high = std::sqrt(std::max(curve.twice_deceleration * distance.high, 0.0));
  const double low = root_low - curve.velocity_offset, high = root_high - curve.velocity_offset;
  if (!(low > 0) || speed.low < 0) return HUGE_VAL;
  const double falls_low = 0.5 * curve.twice_deceleration * speed.low * speed.low / root_high;
  const double falls_high = 0.5 * curve.twice_deceleration * speed.high * speed.high / root_low;
  const double lowest = std::min(acceleration.low * low, acceleration.low * high) + falls_low;
  const double highest = std::max(acceleration.high * low, acceleration.high * high) + falls_high;
  return std::max(std::abs(lowest), std::abs(highest)) / (low * low);
}

/// Raises `worst` to the largest use in the part [a, b] of the piece.
void bisect(const RobotModel::BrakingCurve& curve, const Quintic& quintic, const Direction& towards,
            double a, double b, int depth_left, int& bisections_left, BrakingLimitUse& worst) {
  const double middle = 0.5 * (a + b);
  BrakingLimitUse use =
      braking_limit_use(curve, towards.sign * derivative(quintic, 1, middle),
                        towards.sign * (towards.end - derivative(quintic, 0, middle)));
  use.s = middle;
  if (use.ratio > worst.ratio) worst = use;
  const std::array<Range, 4> part = ranges(quintic, a, b);
  const Interval q = towards.interval_of(part[0]), speed = towards.interval_of(part[1]);
  const double end = towards.sign * towards.end;
  const Interval distance{end - q.high, end - q.low};
  const double half_s = 0.5 * (b - a) * quintic.step_s;
  const double bound = std::min(
      braking_limit_use(curve, speed.high, distance.low).ratio,
      use.ratio + half_s * max_ratio_rate(curve, distance, speed, towards.interval_of(part[2])));
  if (depth_left == 0 || !(bound > worst.ratio * (1 + kBrakingRatioResolution))) return;
  if (--bisections_left < 0) {
    worst.ratio = bound;
    return;
  }
  bisect(curve, quintic, towards, a, middle, depth_left - 1, bisections_left, worst);
  bisect(curve, quintic, towards, middle, b, depth_left - 1, bisections_left, worst);
}

}  // namespace

BrakingLimitUse max_braking_use(const RobotModel::BrakingCurve& curve, const Quintic& quintic,
                                double known_ratio) {
  BrakingLimitUse worst;
  worst.ratio = known_ratio;
  int bisections_left = kMaxBrakingBisections;
  bisect(curve, quintic, {1, curve.upper_end}, 0, 1, kMaxBisectionDepth, bisections_left, worst);
  bisect(curve, quintic, {-1, curve.lower_end}, 0, 1, kMaxBisectionDepth, bisections_left, worst);
  return worst;
}

}  // namespace morphe::verify
