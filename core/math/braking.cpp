#include "core/math/braking.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace morphe::math {
namespace {

constexpr int kMaxBisectionDepth = 40;

double ratio_of(double speed, double left) {
  if (!(speed > 0)) return 0;
  return left > 0 ? speed / left : std::numeric_limits<double>::infinity();
}

/// The search in one direction: v is the velocity towards its end, w the distance to the end, r = v
/// / (s - drop), s = sqrt(slope w).
struct BrakingRatioSearch {
  const RobotModel::BrakingCurve& curve;
  const QuinticPiece& piece;
  bool upwards;
  double best;

  double at(double time_s) const {
    const double v = value_at(piece, time_s, 1);
    return ratio_of(upwards ? v : -v, braking_speed_limit(curve, value_at(piece, time_s), upwards));
  }
  /// Returns an upper bound of r over part of the piece: r at its middle plus at most its slope
  ///   r' = (a (s - drop) + slope v² / 2 s) / (s - drop)²
  /// over the ranges of its terms; or the largest speed divided by the smallest limit.
  double ratio_upper_bound(const QuinticExtremes& over, double middle, double half_s) const {
    const Range v = directed(over.velocity), a = directed(over.acceleration);
    const double least_q = over.position.least, greatest_q = over.position.greatest;
    const double least = braking_speed_limit(curve, upwards ? greatest_q : least_q, upwards);
    const double crude = ratio_of(v.greatest, least);
    if (!(least > 0) || !(v.least >= 0)) return crude;
    const double most = braking_speed_limit(curve, upwards ? least_q : greatest_q, upwards);
    const double bend_least =
        curve.twice_deceleration * v.least * v.least / (2 * (most + curve.velocity_offset));
    const double bend_most =
        curve.twice_deceleration * v.greatest * v.greatest / (2 * (least + curve.velocity_offset));
    const double slowest = std::min(a.least * least, a.least * most) + bend_least;
    const double fastest = std::max(a.greatest * least, a.greatest * most) + bend_most;
    const double slope = std::max(std::abs(slowest), std::abs(fastest)) / (least * least);
    return std::min(crude, middle + slope * half_s);
  }
  Range directed(const Range& range) const {
    return upwards ? range : Range{-range.greatest, -range.least};
  }
  void refine(double from_s, double to_s, int depth) {
    const double middle_s = 0.5 * (from_s + to_s), middle = at(middle_s);
    best = std::max(best, middle);
    const QuinticExtremes over = extremes(piece, from_s, to_s);
    const double most = ratio_upper_bound(over, middle, 0.5 * (to_s - from_s));
    if (!(most > best * (1 + kBrakingRatioTolerance)) || depth == kMaxBisectionDepth) return;
    refine(from_s, middle_s, depth + 1);
    refine(middle_s, to_s, depth + 1);
  }
};

}  // namespace

double braking_speed_limit(const RobotModel::BrakingCurve& curve, double q, bool upwards) {
  const double way = upwards ? curve.upper_end - q : q - curve.lower_end;
  return std::max(0.0,
                  std::sqrt(std::max(0.0, curve.twice_deceleration * way)) - curve.velocity_offset);
}

double braking_ratio(const RobotModel::BrakingCurve& curve, const QuinticPiece& piece,
                     double known) {
  double best = known;
  for (const bool upwards : {true, false}) {
    BrakingRatioSearch search{curve, piece, upwards, best};
    search.refine(0, piece.duration, 0);
    best = search.best;
  }
  return best;
}

}  // namespace morphe::math
