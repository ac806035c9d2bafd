#include "core/humanlike/chain_gradients.hpp"

#include <cmath>

#include "core/humanlike/hull.hpp"
#include "core/humanlike/knots.hpp"

namespace morphe::humanlike {
namespace {

/// A chain, its knots, and the derivatives of a metric with respect to both.
struct ChainAdjoint {
  const Chain& chain;
  std::vector<double> at;
  std::vector<Vec3> by_joint;
  std::vector<double> by_knot;

  explicit ChainAdjoint(const Chain& c)
      : chain(c), at(knots(c)), by_joint(c.size(), Vec3::Zero()), by_knot(c.size(), 0) {}

  /// Adds the derivative of the metric with respect to the point at `place`, and returns its
  /// derivative with respect to the knot of `place`.
  double add_point_gradient(const ChainPoint& place, const Vec3& slope) {
    const std::size_t begin = place.end - 1;
    by_joint[begin] += (1 - place.share) * slope;
    by_joint[place.end] += place.share * slope;
    const double along = slope.dot(chain[place.end] - chain[begin]) / (at[place.end] - at[begin]);
    by_knot[begin] -= (1 - place.share) * along;
    by_knot[place.end] -= place.share * along;
    return along;
  }

  /// Propagates the derivatives with respect to knots to the joints, through the link lengths.
  void propagate_knots() {
    const std::size_t last = chain.size() - 1;
    std::vector<double> length(chain.size(), 0);
    double total = 0;
    for (std::size_t i = 1; i <= last; ++i) total += length[i] = (chain[i] - chain[i - 1]).norm();
    double by_total = 0;  // knot_k = (length_1 + … + length_k) / total, the last one fixed
    for (std::size_t k = 1; k < last; ++k) by_total -= by_knot[k] * at[k] / total;
    double later = 0;  // derivatives of the knots that the link's length moves
    for (std::size_t i = last; i >= 1; --i) {
      if (i < last) later += by_knot[i] / total;
      const Vec3 link = (later + by_total) / length[i] * (chain[i] - chain[i - 1]);
      by_joint[i] += link;
      by_joint[i - 1] -= link;
    }
  }
};

/// Returns the index of a knot among a chain's own knots, or their number if it is not one of them.
std::size_t index_of(const std::vector<double>& at, double knot) {
  std::size_t i = 0;
  while (i < at.size() && std::abs(at[i] - knot) >= 1e-12) ++i;
  return i;
}

}  // namespace

ChainGradient triangle_area_gradient(const Chain& human, const Chain& robot, double smoothing_m2) {
  ChainAdjoint ours(robot), theirs(human);
  const std::vector<double> all = all_knots(theirs.at, ours.at);
  ChainGradient result{0, {}, std::vector<double>(robot.size(), 0)};
  std::vector<double> by_knot(all.size(), 0);
  const auto add_curvature = [&](const ChainPoint& place, double curvature) {
    result.curvature[place.end - 1] += (1 - place.share) * curvature;
    result.curvature[place.end] += place.share * curvature;
  };
  for (std::size_t i = 1; i + 1 < all.size(); ++i) {
    const ChainPoint joint = chain_point(theirs.at, all[i]);
    const ChainPoint corresponding = chain_point(ours.at, all[i]),
                     next = chain_point(ours.at, all[i + 1]);
    const Vec3 a = corresponding.point_on(robot) - joint.point_on(human),
               b = next.point_on(robot) - joint.point_on(human);
    const Vec3 normal = a.cross(b);
    const double smooth = std::sqrt(0.25 * normal.squaredNorm() + smoothing_m2 * smoothing_m2);
    result.value += smooth - smoothing_m2;
    if (smooth == 0) continue;
    const Vec3 by_normal = 0.25 / smooth * normal;
    const Vec3 by_a = b.cross(by_normal), by_b = by_normal.cross(a);
    by_knot[i] += ours.add_point_gradient(corresponding, by_a) +
                  theirs.add_point_gradient(joint, -by_a - by_b);
    by_knot[i + 1] += ours.add_point_gradient(next, by_b);
    add_curvature(corresponding, 0.25 * b.squaredNorm() / smooth);
    add_curvature(next, 0.25 * a.squaredNorm() / smooth);
  }
  for (std::size_t i = 1; i + 1 < all.size(); ++i) {  // knots of the robot's chain move with it
    const std::size_t own = index_of(ours.at, all[i]);
    if (own < ours.at.size()) ours.by_knot[own] += by_knot[i];
  }
  ours.propagate_knots();
  result.gradient = std::move(ours.by_joint);
  return result;
}

ChainGradient hull_gradient(const std::vector<Vec3>& points) {
  ChainGradient result{0, std::vector<Vec3>(points.size(), Vec3::Zero()),
                       std::vector<double>(points.size(), 0)};
  if (points.empty()) return result;
  const Vec3 origin = points.front();  // affects only the round-off of the volume
  for (const auto& facet : hull_facets(points)) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 b = points[facet[(k + 1) % 3]] - origin, c = points[facet[(k + 2) % 3]] - origin;
      const Vec3 share = b.cross(c) / 6;
      result.gradient[facet[k]] += share;
      if (k == 0) result.value += share.dot(points[facet[0]] - origin);
    }
  }
  return result;
}

ChainGradient hull_volume_gradient(const Chain& human, const Chain& robot) {
  const double elbow = knots(human)[1];
  const std::vector<double> at = knots(robot);
  ChainGradient result{0, std::vector<Vec3>(robot.size(), Vec3::Zero()),
                       std::vector<double>(robot.size(), 0)};
  for (const bool upper : {true, false}) {
    std::vector<Vec3> points{human[upper ? 0 : 1], human[upper ? 1 : 2]};
    std::vector<std::size_t> joints;
    for (std::size_t i = 0; i < robot.size(); ++i) {
      if ((at[i] <= elbow) != upper) continue;
      points.push_back(robot[i]);
      joints.push_back(i);
    }
    const ChainGradient hull = hull_gradient(points);
    result.value += hull.value;
    for (std::size_t k = 0; k < joints.size(); ++k)
      result.gradient[joints[k]] = hull.gradient[k + 2];
  }
  return result;
}

}  // namespace morphe::humanlike
