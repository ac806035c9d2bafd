#include "pipeline/math/braking.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace morphe::math {
namespace {

constexpr double kResolution = 1e-10;
constexpr int kDeepest = 50;

double ratio_of(double speed, double left) {
  if (!(speed > 0)) return 0;
  return left > 0 ? speed / left : std::numeric_limits<double>::infinity();
}

struct Search {
  const RobotTable::BrakingCurve& curve;
  const QuinticPiece& piece;
  double best;

  /// Most that the ratio can be anywhere in ranges of positions and velocities.
  double at_most(const Range& q, const Range& v) const {
    return std::max(ratio_of(v.greatest, speed_left(curve, q.greatest, true)),
                    ratio_of(-v.least, speed_left(curve, q.least, false)));
  }
  void refine(double from_s, double to_s, int depth) {
    const double middle_s = 0.5 * (from_s + to_s);
    const double q = value_at(piece, middle_s, 0), v = value_at(piece, middle_s, 1);
    best = std::max(best, at_most({q, q}, {v, v}));
    const QuinticExtremes over = extremes(piece, from_s, to_s);
    const double most = at_most(over.position, over.velocity);
    if (!(most > best * (1 + kResolution)) || depth == kDeepest) return;
    refine(from_s, middle_s, depth + 1);
    refine(middle_s, to_s, depth + 1);
  }
};

}  // namespace

double speed_left(const RobotTable::BrakingCurve& curve, double q, bool upwards) {
  const double way = upwards ? curve.upper_end - q : q - curve.lower_end;
  return std::max(0.0, std::sqrt(std::max(0.0, curve.slope * way)) - curve.drop);
}

double braking_ratio(const RobotTable::BrakingCurve& curve, const QuinticPiece& piece,
                     double known) {
  Search search{curve, piece, known};
  search.refine(0, piece.duration, 0);
  return search.best;
}

}  // namespace morphe::math
