#include "core/math/braking.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::math {
namespace {

constexpr int kMaxBisectionDepth = 40;

double ratio_of(double speed, double limit) {
  if (!(speed > 0)) return 0;
  return limit > 0 ? speed / limit : kInfinity;
}

/// The search for the largest r in one direction: v is the velocity towards the range's end, w the
/// distance to it, k the twice_deceleration, s = sqrt(k w), and r = v / (s - velocity_offset).
struct BrakingRatioSearch {
  const RobotModel::BrakingCurve& curve;
  const QuinticPiece& piece;
  bool upwards;
  double max_ratio;

  double ratio_at(double time_s) const {
    const double v = value_at(piece, time_s, 1);
    return ratio_of(upwards ? v : -v, braking_speed_limit(curve, value_at(piece, time_s), upwards));
  }
  /// Returns an upper bound of r over part of the piece: r at its middle plus half_s |r'|, where
  ///   r' = (a (s - velocity_offset) + k v² / 2 s) / (s - velocity_offset)²
  /// over the ranges of its terms; or the largest speed divided by the smallest limit, if less.
  double ratio_upper_bound(const QuinticExtremes& over, double middle_ratio, double half_s) const {
    const Range v = directed(over.velocity), a = directed(over.acceleration);
    const auto [least_q, greatest_q] = over.position;
    const double low = braking_speed_limit(curve, upwards ? greatest_q : least_q, upwards);
    const double crude = ratio_of(v.greatest, low);
    if (!(low > 0) || !(v.least >= 0)) return crude;
    const double high = braking_speed_limit(curve, upwards ? least_q : greatest_q, upwards);
    const double min_bend =
        curve.twice_deceleration * v.least * v.least / (2 * (high + curve.velocity_offset));
    const double max_bend =
        curve.twice_deceleration * v.greatest * v.greatest / (2 * (low + curve.velocity_offset));
    const double min_numerator = std::min(a.least * low, a.least * high) + min_bend;
    const double max_numerator = std::max(a.greatest * low, a.greatest * high) + max_bend;
    const double slope = std::max(std::abs(min_numerator), std::abs(max_numerator)) / (low * low);
    return std::min(crude, middle_ratio + slope * half_s);
  }
  Range directed(const Range& range) const {
    return upwards ? range : Range{-range.greatest, -range.least};
  }
  void refine(double from_s, double to_s, int depth) {
    const double middle_s = 0.5 * (from_s + to_s), middle_ratio = ratio_at(middle_s);
    max_ratio = std::max(max_ratio, middle_ratio);
    const QuinticExtremes over = extremes(piece, from_s, to_s);
    const double bound = ratio_upper_bound(over, middle_ratio, 0.5 * (to_s - from_s));
    if (!(bound > max_ratio * (1 + kBrakingRatioTolerance)) || depth == kMaxBisectionDepth) return;
    refine(from_s, middle_s, depth + 1);
    refine(middle_s, to_s, depth + 1);
  }
};

}  // namespace

double braking_speed_limit(const RobotModel::BrakingCurve& curve, double q, bool upwards) {
  const double distance = upwards ? curve.upper_end - q : q - curve.lower_end;
  const double speed = std::sqrt(std::max(0.0, curve.twice_deceleration * distance));
  return std::max(0.0, speed - curve.velocity_offset);
}

double braking_ratio(const RobotModel::BrakingCurve& curve, const QuinticPiece& piece,
                     double known) {
  double max_ratio = known;
  for (const bool upwards : {true, false}) {
    BrakingRatioSearch search{curve, piece, upwards, max_ratio};
    search.refine(0, piece.duration, 0);
    max_ratio = search.max_ratio;
  }
  return max_ratio;
}

}  // namespace morphe::math
