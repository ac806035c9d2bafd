#include "core/humanlike/chain_gradients.hpp"

#include <algorithm>
#include <cmath>

#include "core/humanlike/hull.hpp"

namespace morphe::humanlike {
namespace {

/// A chain, its knots, and the derivatives of a metric with respect to its joints and knots.
struct ChainAdjoint {
  const Chain& chain;
  std::vector<double> own_knots;
  std::vector<Vec3> by_joint;
  std::vector<double> by_knot;

  explicit ChainAdjoint(const Chain& c)
      : chain(c), own_knots(knots(c)), by_joint(c.size(), Vec3::Zero()), by_knot(c.size(), 0) {}

  /// Adds the metric's gradient `slope` at a point of the chain to the derivatives; returns that
  /// with respect to the point's own knot.
  double add_point_gradient(const ChainPoint& point, const Vec3& slope) {
    const std::ptrdiff_t end = point.end, begin = end - 1;
    by_joint[begin] += (1 - point.share) * slope;
    by_joint[end] += point.share * slope;
    const double along = slope.dot(chain[end] - chain[begin]) / (own_knots[end] - own_knots[begin]);
    by_knot[begin] -= (1 - point.share) * along;
    by_knot[end] -= point.share * along;
    return along;
  }

  /// Propagates the derivatives with respect to knots to the joints, through the link lengths.
  void propagate_knots() {
    const std::ptrdiff_t last = std::ssize(chain) - 1;
    std::vector<double> length(chain.size(), 0);
    double total = 0;
    for (int i = 1; i <= last; ++i) total += length[i] = (chain[i] - chain[i - 1]).norm();
    double by_total = 0;  // knot_k = (length_1 + … + length_k) / total; the last is 1
    for (int k = 1; k < last; ++k) by_total -= by_knot[k] * own_knots[k] / total;
    double later = 0;  // derivative by link i's length: sum over the knots i … last - 1
    for (std::ptrdiff_t i = last; i >= 1; --i) {
      if (i < last) later += by_knot[i] / total;
      const Vec3 link = (later + by_total) / length[i] * (chain[i] - chain[i - 1]);
      by_joint[i] += link;
      by_joint[i - 1] -= link;
    }
  }
};

}  // namespace

ChainGradient triangle_area_gradient(const Chain& human, const Chain& robot, double smoothing_m2) {
  ChainAdjoint ours(robot), theirs(human);
  const std::vector<double> all = all_knots(theirs.own_knots, ours.own_knots);
  ChainGradient result{0, {}, std::vector<double>(robot.size(), 0)};
  std::vector<double> by_knot(all.size(), 0);
  const auto add_curvature = [&](const ChainPoint& point, double curvature) {
    result.curvature[point.end - 1] += (1 - point.share) * curvature;
    result.curvature[point.end] += point.share * curvature;
  };
  for (int i = 1; i + 1 < std::ssize(all); ++i) {
    const ChainPoint joint = chain_point(theirs.own_knots, all[i]);
    const ChainPoint corresponding = chain_point(ours.own_knots, all[i]);
    const ChainPoint next = chain_point(ours.own_knots, all[i + 1]);
    const Vec3 a = corresponding.point_on(robot) - joint.point_on(human);
    const Vec3 b = next.point_on(robot) - joint.point_on(human);
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
  for (int i = 1; i + 1 < std::ssize(all); ++i) {  // knots of the robot's chain move with it
    const auto own = std::ranges::find_if(
        ours.own_knots, [&](double knot) { return !(std::abs(knot - all[i]) >= 1e-12); });
    if (own != ours.own_knots.end()) ours.by_knot[own - ours.own_knots.begin()] += by_knot[i];
  }
  ours.propagate_knots();
  result.gradient = std::move(ours.by_joint);
  return result;
}

ChainGradient hull_gradient(const std::vector<Vec3>& points) {
  ChainGradient result{0, std::vector<Vec3>(points.size(), Vec3::Zero()),
                       std::vector<double>(points.size(), 0)};
  if (points.empty()) return result;
  const Vec3 origin = points.front();  // any point; affects only rounding
  for (const auto& facet : hull_facets(points)) {
    for (int k = 0; k < 3; ++k) {
      const Vec3 b = points[facet[(k + 1) % 3]] - origin, c = points[facet[(k + 2) % 3]] - origin;
      const Vec3 by_corner = b.cross(c) / 6;
      result.gradient[facet[k]] += by_corner;
      if (k == 0) result.value += by_corner.dot(points[facet[0]] - origin);
    }
  }
  return result;
}

ChainGradient hull_volume_gradient(const Chain& human, const Chain& robot) {
  const double elbow_knot = knots(human)[1];
  const std::vector<double> robot_knots = knots(robot);
  ChainGradient result{0, std::vector<Vec3>(robot.size(), Vec3::Zero()),
                       std::vector<double>(robot.size(), 0)};
  for (const bool upper : {true, false}) {
    std::vector<Vec3> points{human[upper ? 0 : 1], human[upper ? 1 : 2]};
    std::vector<int> joints;
    for (int i = 0; i < std::ssize(robot); ++i) {
      if ((robot_knots[i] <= elbow_knot) != upper) continue;
      points.push_back(robot[i]);
      joints.push_back(i);
    }
    const ChainGradient hull = hull_gradient(points);
    result.value += hull.value;
    for (int k = 0; k < std::ssize(joints); ++k) result.gradient[joints[k]] = hull.gradient[k + 2];
  }
  return result;
}

}  // namespace morphe::humanlike
