#include "core/closure/nearest_point.hpp"

#include <Eigen/QR>
#include <array>
#include <cassert>

namespace morphe::closure {
namespace {

/// Points for which 0 is nearest to the interior of their hull: x = sum share_k point_k, shares
/// above 0, sum 1.
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
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) x += share[k] * point[k];
    return x;
  }
};

/// Computes the shares, of any sign, of the point of the affine hull that is nearest to 0.
std::array<double, 8> affine_shares(const Corral& corral) {
  std::array<double, 8> shares{};
  const int edges = corral.count - 1;
  WrenchColumns matrix(6, edges);
  for (int k = 0; k < edges; ++k) {
    matrix.col(k) = corral.point[k + 1] - corral.point[0];
  }
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
    const std::array<double, 8> wanted = affine_shares(corral);
    double step = 1;
    int blocking = -1;
    for (int k = 0; k < corral.count; ++k) {
      const auto i = static_cast<std::size_t>(k);
      if (wanted[i] > 0) continue;
      const double until = corral.share[i] / (corral.share[i] - wanted[i]);
      // Points whose share is 0 and remains 0 do not block: 0 / 0 compares false.
      if (until < step || (blocking < 0 && until <= step)) {
        step = until;
        blocking = k;
      }
    }
    double sum = 0;
    for (int k = 0; k < corral.count; ++k) {
      const auto i = static_cast<std::size_t>(k);
      corral.share[i] = std::max(0.0, corral.share[i] + step * (wanted[i] - corral.share[i]));
      sum += corral.share[i];
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
  Wrench u = Wrench::Zero();
  u[0] = 1;
  corral.add(support(set, u).point);
  corral.share[0] = 1;
  double nearest = kInfinity;
  for (int k = 0; k < tolerance.max_insertions; ++k) {
    const Wrench x = corral.nearest();
    const double distance = x.norm();
    bounds.lower = std::max(bounds.lower, -distance - set.rounding);
    if (distance <= set.rounding || distance >= nearest) break;
    nearest = distance;
    u = -x / distance;
    const Support there = support(set, u);
    bounds.update_upper(there.value + set.support_error(), u);
    if (bounds.upper < 0 && is_within_tolerance(bounds, tolerance)) break;
    if (there.value <= -distance + set.rounding || corral.count == 7) break;
    corral.add(there.point);
    minimise_over_corral(corral);
  }
  return bounds;
}

}  // namespace morphe::closure
