#include "pipeline/verify/braking.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::verify {
namespace {

constexpr double kResolution = 1e-10;
constexpr int kMostHalvings = 50;

/// Speed upwards (negative: downwards) with so much way left to that end.
BrakingUse use_of(const RobotTable::BrakingCurve& curve, double speed, double way) {
  const double root = std::sqrt(std::max(curve.slope * way, 0.0));
  const double left = std::max(root - curve.drop, 0.0);
  const double ratio = speed <= 0 ? 0 : left > 0 ? speed / left : HUGE_VAL;
  return {ratio, 0, speed, left};
}

/// Of the least and greatest position and velocity, as if they came together.
BrakingUse worse_of(const RobotTable::BrakingCurve& curve, double q0, double q1, double v0,
                    double v1) {
  const BrakingUse up = use_of(curve, v1, curve.upper_end - q1);
  const BrakingUse down = use_of(curve, -v0, q0 - curve.lower_end);
  return up.ratio >= down.ratio ? up : down;
}

void search(const RobotTable::BrakingCurve& curve, const Quintic& quintic, double a, double b,
            int halvings, BrakingUse& worst) {
  const double middle = 0.5 * (a + b);
  const double q = derivative(quintic, 0, middle), v = derivative(quintic, 1, middle);
  BrakingUse here = worse_of(curve, q, q, v, v);
  here.s = middle;
  if (here.ratio > worst.ratio) worst = here;
  const auto [position, velocity, acceleration, jerk] = ranges(quintic, a, b);
  const BrakingUse bound = worse_of(curve, position.least.value, position.greatest.value,
                                    velocity.least.value, velocity.greatest.value);
  if (halvings == 0 || !(bound.ratio > worst.ratio * (1 + kResolution))) return;
  search(curve, quintic, a, middle, halvings - 1, worst);
  search(curve, quintic, middle, b, halvings - 1, worst);
}

}  // namespace

BrakingUse worst_braking(const RobotTable::BrakingCurve& curve, const Quintic& quintic,
                         double known) {
  BrakingUse worst;
  worst.ratio = known;
  search(curve, quintic, 0, 1, kMostHalvings, worst);
  return worst;
}

}  // namespace morphe::verify
