#include "core/humanlike/chain_slopes.hpp"

#include <cmath>

#include "core/humanlike/hull.hpp"
#include "core/humanlike/knots.hpp"

namespace morphe::humanlike {
namespace {

/// A chain, its knots and what a metric's slopes by both are.
struct Sloped {
  const Chain& chain;
  std::vector<double> at;
  std::vector<Vec3> by_joint;
  std::vector<double> by_knot;

  explicit Sloped(const Chain& c)
      : chain(c), at(knots(c)), by_joint(c.size(), Vec3::Zero()), by_knot(c.size(), 0) {}

  /// The metric has the slope by the point at a place: returns its slope by the place's knot.
  double pull(const ChainPoint& place, const Vec3& slope) {
    const std::size_t begin = place.end - 1;
    by_joint[begin] += (1 - place.share) * slope;
    by_joint[place.end] += place.share * slope;
    const double along = slope.dot(chain[place.end] - chain[begin]) / (at[place.end] - at[begin]);
    by_knot[begin] -= (1 - place.share) * along;
    by_knot[place.end] -= place.share * along;
    return along;
  }

  /// Passes the slopes by knots on to the joints, through the link lengths.
  void settle() {
    const std::size_t last = chain.size() - 1;
    std::vector<double> length(chain.size(), 0);
    double total = 0;
    for (std::size_t i = 1; i <= last; ++i) total += length[i] = (chain[i] - chain[i - 1]).norm();
    double by_total = 0;  // knot_k = (length_1 + … + length_k) / total, the last one fixed
    for (std::size_t k = 1; k < last; ++k) by_total -= by_knot[k] * at[k] / total;
    double later = 0;  // slopes of the knots that a link's length moves
    for (std::size_t i = last; i >= 1; --i) {
      if (i < last) later += by_knot[i] / total;
      const Vec3 link = (later + by_total) / length[i] * (chain[i] - chain[i - 1]);
      by_joint[i] += link;
      by_joint[i - 1] -= link;
    }
  }
};

/// Which of a chain's own knots a knot is, if any.
std::size_t index_of(const std::vector<double>& at, double knot) {
  std::size_t i = 0;
  while (i < at.size() && std::abs(at[i] - knot) >= 1e-12) ++i;
  return i;
}

}  // namespace

ChainSlopes triangle_area_slopes(const Chain& human, const Chain& robot, double smoothing_m2) {
  Sloped ours(robot), theirs(human);
  const std::vector<double> all = all_knots(theirs.at, ours.at);
  ChainSlopes result{0, {}, std::vector<double>(robot.size(), 0)};
  std::vector<double> by_knot(all.size(), 0);
  const auto add_curvature = [&](const ChainPoint& place, double curvature) {
    result.curvature[place.end - 1] += (1 - place.share) * curvature;
    result.curvature[place.end] += place.share * curvature;
  };
  for (std::size_t i = 1; i + 1 < all.size(); ++i) {
    const ChainPoint joint = chain_point(theirs.at, all[i]);
    const ChainPoint corresponding = chain_point(ours.at, all[i]),
                     next = chain_point(ours.at, all[i + 1]);
    const Vec3 a = corresponding.on(robot) - joint.on(human), b = next.on(robot) - joint.on(human);
    const Vec3 normal = a.cross(b);
    const double smooth = std::sqrt(0.25 * normal.squaredNorm() + smoothing_m2 * smoothing_m2);
    result.value += smooth - smoothing_m2;
    if (smooth == 0) continue;
    const Vec3 by_normal = 0.25 / smooth * normal;
    const Vec3 by_a = b.cross(by_normal), by_b = by_normal.cross(a);
    by_knot[i] += ours.pull(corresponding, by_a) + theirs.pull(joint, -by_a - by_b);
    by_knot[i + 1] += ours.pull(next, by_b);
    add_curvature(corresponding, 0.25 * b.squaredNorm() / smooth);
    add_curvature(next, 0.25 * a.squaredNorm() / smooth);
  }
  for (std::size_t i = 1; i + 1 < all.size(); ++i) {  // knots that are the robot's move with it
    const std::size_t own = index_of(ours.at, all[i]);
    if (own < ours.at.size()) ours.by_knot[own] += by_knot[i];
  }
  ours.settle();
  result.slope = std::move(ours.by_joint);
  return result;
}

ChainSlopes hull_slopes(const std::vector<Vec3>& points) {
  ChainSlopes result{0, std::vector<Vec3>(points.size(), Vec3::Zero()),
                     std::vector<double>(points.size(), 0)};
  if (points.empty()) return result;
  const Vec3 origin = points.front();  // a volume does not depend on it, its round-off does
  for (const auto& facet : hull_facets(points)) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 b = points[facet[(k + 1) % 3]] - origin, c = points[facet[(k + 2) % 3]] - origin;
      const Vec3 share = b.cross(c) / 6;
      result.slope[facet[k]] += share;
      if (k == 0) result.value += share.dot(points[facet[0]] - origin);
    }
  }
  return result;
}

ChainSlopes hull_volume_slopes(const Chain& human, const Chain& robot) {
  const double elbow = knots(human)[1];
  const std::vector<double> at = knots(robot);
  ChainSlopes result{0, std::vector<Vec3>(robot.size(), Vec3::Zero()),
                     std::vector<double>(robot.size(), 0)};
  for (const bool upper : {true, false}) {
    std::vector<Vec3> points{human[upper ? 0 : 1], human[upper ? 1 : 2]};
    std::vector<std::size_t> joints;
    for (std::size_t i = 0; i < robot.size(); ++i) {
      if ((at[i] <= elbow) != upper) continue;
      points.push_back(robot[i]);
      joints.push_back(i);
    }
    const ChainSlopes hull = hull_slopes(points);
    result.value += hull.value;
    for (std::size_t k = 0; k < joints.size(); ++k) result.slope[joints[k]] = hull.slope[k + 2];
  }
  return result;
}

}  // namespace morphe::humanlike
