#include "core/closure/nearest_point.hpp"

#include <Eigen/QR>
#include <array>
#include <cassert>

namespace morphe::closure {
namespace {

/// Points whose hull is nearest to 0 at sum share_k point_k, with shares above 0 of sum 1.
struct Corral {
  std::array<Wrench, 8> point;
  std::array<double, 8> share{};
  int count = 0;

  void add(const Wrench& added) {
    point[count] = added;
    share[count++] = 0;
  }
  void remove(int k) {
    for (int j = k; j + 1 < count; ++j) {
      point[j] = point[j + 1];
      share[j] = share[j + 1];
    }
    --count;
  }
  Wrench nearest() const {
    Wrench x = Wrench::Zero();
    for (int k = 0; k < count; ++k) x += share[k] * point[k];
    return x;
  }
};

/// Computes the shares, of any sign, of the point of the affine hull that is nearest to 0.
std::array<double, 8> affine_shares(const Corral& corral) {
  std::array<double, 8> shares{};
  const int edges = corral.count - 1;
  WrenchColumns matrix(6, edges);
  for (int k = 0; k < edges; ++k) matrix.col(k) = corral.point[k + 1] - corral.point[0];
  shares[0] = 1;
  if (edges == 0) return shares;
  const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 7, 1> solved =
      matrix.colPivHouseholderQr().solve(-corral.point[0]);
  for (int k = 0; k < edges; ++k) {
    shares[k + 1] = solved[k];
    shares[0] -= solved[k];
  }
  return shares;
}

/// Moves to the nearest point of the hull of the corral, and removes points whose share is 0.
void minimise_over_corral(Corral& corral) {
  while (true) {
    const std::array<double, 8> target = affine_shares(corral);
    double step = 1;
    int blocking = -1;
    for (int k = 0; k < corral.count; ++k) {
      if (target[k] > 0) continue;
      const double fraction = corral.share[k] / (corral.share[k] - target[k]);
      // Points whose share is 0 and remains 0 do not block: 0 / 0 compares false.
      if (fraction < step || (blocking < 0 && fraction <= step)) {
        step = fraction;
        blocking = k;
      }
    }
    double sum = 0;
    for (int k = 0; k < corral.count; ++k) {
      corral.share[k] = std::max(0.0, corral.share[k] + step * (target[k] - corral.share[k]));
      sum += corral.share[k];
    }
    for (double& share : corral.share) share /= sum;
    if (blocking < 0) return;
    corral.remove(blocking);
  }
}

}  // namespace

Bounds negative_origin_distance(const WrenchSet& set, const BoundTolerance& tolerance) {
  assert(!set.cones.empty());
  Bounds bounds;
  Corral corral;
  Wrench u = Wrench::Unit(0);
  corral.add(support(set, u).point);
  corral.share[0] = 1;
  double last_distance = kInfinity;
  for (int k = 0; k < tolerance.max_insertions; ++k) {
    const Wrench x = corral.nearest();
    const double distance = x.norm();
    bounds.lower = std::max(bounds.lower, -distance - set.rounding);
    if (distance <= set.rounding || distance >= last_distance) break;
    last_distance = distance;
    u = -x / distance;
    const Support farthest = support(set, u);
    bounds.update_upper(farthest.value + set.support_error(), u);
    if (bounds.upper < 0 && is_within_tolerance(bounds, tolerance)) break;
    if (farthest.value <= -distance + set.rounding || corral.count == 7) break;
    corral.add(farthest.point);
    minimise_over_corral(corral);
  }
  return bounds;
}

}  // namespace morphe::closure
