#include "core/collision/convex_distance.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/collision/constants.hpp"

namespace morphe::collision {
namespace {

using Core = ConvexBody::Core;

/// Returns the point of a body's core that is farthest in a direction.
Vec3 support_point(const ConvexBody& body, const Vec3& direction) {
  if (body.core == Core::triangle) {
    return *std::ranges::max_element(body.corners, {},
                                     [&](const Vec3& corner) { return corner.dot(direction); });
  }
  const Vec3 along = body.axes.transpose() * direction;
  Vec3 point = along.array().sign() * body.half.array();
  if (body.core == Core::cylinder) {
    const double radial = std::hypot(along.x(), along.y());
    point.head<2>().setZero();
    if (radial > 0) point.head<2>() = body.half.x() / radial * along.head<2>();
  }
  return body.centre + body.axes * point;
}

/// A point of the set of differences of the two cores, with the points that it comes from.
struct Difference {
  Vec3 on_first, on_second;
  Vec3 vector() const { return on_first - on_second; }
};

Difference support_difference(const ConvexBody& first, const ConvexBody& second,
                              const Vec3& direction) {
  return {support_point(first, direction), support_point(second, -direction)};
}

/// Some of at most four differences, and the weights of their combination nearest to the origin.
struct Simplex {
  std::array<Difference, 4> points;
  std::array<double, 4> weights{};
  int count = 0;

  Difference nearest() const {
    Difference sum{Vec3::Zero(), Vec3::Zero()};
    for (int i = 0; i < count; ++i) {
      sum.on_first += weights[i] * points[i].on_first;
      sum.on_second += weights[i] * points[i].on_second;
    }
    return sum;
  }
};

/// Returns the weights of all points but the first in their affine combination that is nearest to
/// the origin; NaN or large if the points are dependent.
template <int n>
Eigen::Matrix<double, n, 1> nearest_weights(const Simplex& simplex) {
  Eigen::Matrix<double, 3, n> edges;
  const Vec3 first = simplex.points[0].vector();
  for (int i = 0; i < n; ++i) edges.col(i) = simplex.points[i + 1].vector() - first;
  const Eigen::Matrix<double, n, n> gram = edges.transpose() * edges;
  return -(gram.inverse() * (edges.transpose() * first));
}

/// Sets the weights; returns true if they are positive, so that the combination is in the simplex.
bool weigh(Simplex& simplex) {
  std::array<double, 4> weights{1, 0, 0, 0};
  const auto fill = [&](const auto& others) {
    for (int i = 0; i < others.size(); ++i) weights[i + 1] = others[i];
    weights[0] = 1 - others.sum();
  };
  if (simplex.count == 2) fill(nearest_weights<1>(simplex));
  if (simplex.count == 3) fill(nearest_weights<2>(simplex));
  if (simplex.count == 4) fill(nearest_weights<3>(simplex));
  simplex.weights = weights;
  return std::all_of(weights.begin(), weights.begin() + simplex.count,
                     [](double weight) { return weight > 0; });
}

/// Returns the part of the simplex, with its last point, whose combination is nearest to the
/// origin.
Simplex nearest_part(const Simplex& simplex) {
  Simplex best;
  double least = kInfinity;
  const int last = simplex.count - 1;
  for (int members = 0; members < 1 << last; ++members) {
    Simplex part;
    part.points[part.count++] = simplex.points[last];
    for (int i = 0; i < last; ++i)
      if (members >> i & 1) part.points[part.count++] = simplex.points[i];
    if (!weigh(part)) continue;
    const double squared = part.nearest().vector().squaredNorm();
    if (squared < least) {
      least = squared;
      best = part;
    }
  }
  return best;
}

/// Returns the normal of a simplex of two or three points, on the side of a combination of them:
/// the direction from the origin to its plane or line, more exact than the combination itself.
Vec3 normal_of(const Simplex& simplex, const Vec3& combination) {
  const auto edge = [&](int point) -> Vec3 {
    return simplex.points[point].vector() - simplex.points[0].vector();
  };
  Vec3 normal = combination;
  if (simplex.count == 3) normal = edge(1).cross(edge(2));
  if (simplex.count == 2) normal -= edge(1) * (edge(1).dot(normal) / edge(1).squaredNorm());
  if (!(normal.norm() > 0)) normal = combination;
  return normal.dot(combination) < 0 ? Vec3(-normal.normalized()) : Vec3(normal.normalized());
}

/// The nearest points of two cores, and the direction from second to first in which they are found
/// to be farthest apart; equal points, or nearly, if the cores overlap.
struct NearestCores {
  Difference points;
  Vec3 direction = Vec3::Zero();
};

NearestCores nearest_points(const ConvexBody& first, const ConvexBody& second) {
  Simplex simplex;
  NearestCores best{{first.centre, second.centre}};
  double lower_m = -kInfinity;  // of the distance
  for (int k = 0; k < kMaxSupportPoints; ++k) {
    const Vec3 nearest = best.points.vector();
    const double distance_m = nearest.norm();
    if (distance_m <= kCoincidence_m) break;
    const Vec3 direction = normal_of(simplex, nearest);
    const Difference next = support_difference(first, second, -direction);
    if (next.vector().dot(direction) > lower_m) {
      lower_m = next.vector().dot(direction);
      best.direction = direction;
    }
    if (k > 0 && distance_m - lower_m <= kConvexResolution_m) break;
    simplex.points[simplex.count++] = next;
    const Simplex part = nearest_part(simplex);
    const Difference candidate = part.nearest();
    if (k > 0 && !(candidate.vector().norm() < distance_m)) break;
    simplex = part;
    best.points = candidate;
    if (part.count == 4) break;  // the origin is inside
  }
  return best;
}

/// Returns the normals of faces, or the directions of edges, that can separate overlapping cores.
std::vector<Vec3> face_normals(const ConvexBody& body, const Vec3& from_other) {
  if (body.core == Core::triangle) {
    const Vec3 normal =
        (body.corners[1] - body.corners[0]).cross(body.corners[2] - body.corners[0]);
    return {normal};
  }
  if (body.core == Core::cylinder) {
    const Vec3 axis = body.axes.col(2);
    return {axis, from_other - axis.dot(from_other) * axis};
  }
  return {body.axes.col(0), body.axes.col(1), body.axes.col(2)};
}

std::vector<Vec3> edges_of(const ConvexBody& body) {
  if (body.core == Core::cylinder) return {body.axes.col(2)};
  if (body.core == Core::box) return {body.axes.col(0), body.axes.col(1), body.axes.col(2)};
  return {body.corners[1] - body.corners[0], body.corners[2] - body.corners[1],
          body.corners[0] - body.corners[2]};
}

ConvexBody shrunk(const ConvexBody& body, double share) {
  ConvexBody small = body;
  small.half *= share;
  for (Vec3& corner : small.corners) corner = body.centre + share * (corner - body.centre);
  return small;
}

std::vector<Vec3> separating_directions(const ConvexBody& first, const ConvexBody& second) {
  const Vec3 between = first.centre - second.centre;
  std::vector<Vec3> directions = face_normals(first, between);
  for (const Vec3& normal : face_normals(second, between)) directions.push_back(normal);
  for (const Vec3& a : edges_of(first))
    for (const Vec3& b : edges_of(second)) directions.push_back(a.cross(b));
  directions.push_back(between);
  const bool round = first.core == Core::cylinder || second.core == Core::cylinder;
  if (!round) return directions;  // these are all that can be the best one
  for (const double share : kShrinkShares)
    directions.push_back(nearest_points(shrunk(first, share), shrunk(second, share)).direction);
  return directions;
}

/// Returns the separation whose planes have this normal; the least of all if it is not a direction.
ConvexSeparation along(const ConvexBody& first, const ConvexBody& second, const Vec3& direction) {
  ConvexSeparation result;
  result.distance = -kInfinity;
  const double length = direction.norm();
  if (!(length > kCoincidence_m)) return result;
  result.normal = direction / length;
  const Difference nearest = support_difference(first, second, -result.normal);
  result.distance = nearest.vector().dot(result.normal) - first.radius - second.radius;
  result.on_first = nearest.on_first - first.radius * result.normal;
  result.on_second = result.on_first - result.distance * result.normal;
  return result;
}

ConvexSeparation deepest(const ConvexBody& first, const ConvexBody& second) {
  ConvexSeparation best = along(first, second, Vec3::UnitZ());
  for (const Vec3& direction : separating_directions(first, second)) {
    for (const double sign : {1.0, -1.0}) {
      const ConvexSeparation tried = along(first, second, sign * direction);
      if (tried.distance > best.distance) best = tried;
    }
  }
  return best;
}

}  // namespace

ConvexSeparation convex_distance(const ConvexBody& first, const ConvexBody& second) {
  const auto [nearest, direction] = nearest_points(first, second);
  ConvexSeparation result = along(first, second, direction);
  // Planes that overlap, but for the grown radii, show that the cores do.
  if (!(result.distance + first.radius + second.radius > 0)) return deepest(first, second);
  result.on_first = nearest.on_first - first.radius * result.normal;
  result.on_second = nearest.on_second + second.radius * result.normal;
  return result;
}

}  // namespace morphe::collision
