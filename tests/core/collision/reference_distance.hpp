#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/collision/distance.hpp"

namespace morphe::collision {

/// The distance of a segment from a solid as the convex problem it is, min |x - y| over x on the
/// segment and y in the solid, from first principles: no closed form of core/collision is used.
/// `upper` is the distance of two points found, `lower` the gap that the plane across them proves
/// (weak duality): the truth lies between. Both 0 where the segment runs through the solid.
struct ReferenceDistance {
  double lower = 0, upper = 0;
};

namespace reference {

/// The solid's point nearest to p, all in the solid's frame.
inline Vec3 nearest_in(const SceneObject& solid, const Vec3& p) {
  const auto& size = solid.size;
  const auto round = [&](double half) {
    const Vec3 axis(0, 0, std::clamp(p.z(), -half, half));
    const double away = (p - axis).norm();
    return away <= size[0] ? p : Vec3(axis + size[0] / away * (p - axis));
  };
  if (solid.shape == Shape::sphere) return round(0);
  if (solid.shape == Shape::capsule) return round(0.5 * size[1]);
  if (solid.shape == Shape::box) {
    const Vec3 half = 0.5 * Vec3(size[0], size[1], size[2]);
    return p.cwiseMax(-half).cwiseMin(half);
  }
  const double from_axis = p.head<2>().norm(), shrink = std::min(1.0, size[0] / from_axis);
  const double half = 0.5 * size[1];
  return {p.x() * (from_axis > 0 ? shrink : 1), p.y() * (from_axis > 0 ? shrink : 1),
          std::clamp(p.z(), -half, half)};
}

/// max over y in the solid of n y.
inline double support(const SceneObject& solid, const Vec3& n) {
  const auto& size = solid.size;
  switch (solid.shape) {
    case Shape::sphere:
      return size[0] * n.norm();
    case Shape::capsule:
      return size[0] * n.norm() + 0.5 * size[1] * std::abs(n.z());
    case Shape::box:
      return 0.5 * n.cwiseAbs().dot(Vec3(size[0], size[1], size[2]));
    case Shape::cylinder:
      return size[0] * n.head<2>().norm() + 0.5 * size[1] * std::abs(n.z());
    case Shape::mesh:
      break;
  }
  double most = -std::numeric_limits<double>::infinity();
  for (const Vec3& vertex : solid.vertices) most = std::max(most, n.dot(vertex));
  return most;
}

/// Nearest point of a triangle: the least of its plane's foot, if inside, and of its edges' points.
inline Vec3 nearest_in_triangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  Vec3 best = a;
  const auto keep = [&](const Vec3& point) {
    if ((point - p).squaredNorm() < (best - p).squaredNorm()) best = point;
  };
  const Vec3* corners[] = {&a, &b, &c, &a};
  for (int k = 0; k < 3; ++k) {
    const Vec3 edge = *corners[k + 1] - *corners[k];
    keep(*corners[k] +
         std::clamp((p - *corners[k]).dot(edge) / edge.squaredNorm(), 0.0, 1.0) * edge);
  }
  Eigen::Matrix<double, 3, 2> sides;
  sides << b - a, c - a;
  const Eigen::Vector2d uv = (sides.transpose() * sides).inverse() * sides.transpose() * (p - a);
  if (uv.minCoeff() >= 0 && uv.sum() <= 1) keep(a + sides * uv);
  return best;
}

}  // namespace reference

/// A convex mesh's solid is given by its triangles, seen from outside.
inline ReferenceDistance reference_distance(const Vec3& from, const Vec3& to,
                                            const SceneObject& solid) {
  const auto nearest = [&](const Vec3& p) {
    if (solid.shape != Shape::mesh) return reference::nearest_in(solid, p);
    bool within = true;
    Vec3 best = solid.vertices.front();
    for (const Eigen::Vector3i& t : solid.triangles) {
      const Vec3& a = solid.vertices[static_cast<std::size_t>(t[0])];
      const Vec3& b = solid.vertices[static_cast<std::size_t>(t[1])];
      const Vec3& c = solid.vertices[static_cast<std::size_t>(t[2])];
      const Vec3 normal = (b - a).cross(c - a);  // outwards or inwards: the origin is inside
      within = within && normal.dot(p - a) * normal.dot(-a) >= 0;
      const Vec3 here = reference::nearest_in_triangle(a, b, c, p);
      if ((here - p).squaredNorm() < (best - p).squaredNorm()) best = here;
    }
    return within ? p : best;
  };
  // The distance is convex along the segment; its slope's sign tells the side of the minimum.
  const Vec3 along = to - from;
  double low = 0, high = 1;
  for (int k = 0; k < 100; ++k) {
    const double s = 0.5 * (low + high);
    const Vec3 x = from + s * along, out = x - nearest(x);
    if (out.squaredNorm() == 0) return {};
    (out.dot(along) < 0 ? low : high) = s;
  }
  ReferenceDistance best{0, std::numeric_limits<double>::infinity()};
  for (const double s : {0.0, low, 0.5 * (low + high), high, 1.0}) {
    const Vec3 x = from + s * along, out = x - nearest(x);
    const double apart = out.norm();
    if (apart == 0) return {};
    best.upper = std::min(best.upper, apart);
    const Vec3 n = out / apart;
    best.lower =
        std::max(best.lower, std::min(n.dot(from), n.dot(to)) - reference::support(solid, n));
  }
  // A plane whose normal lies between those at both sides of the minimum is across the segment.
  const Vec3 a = from + low * along - nearest(from + low * along);
  const Vec3 b = from + high * along - nearest(from + high * along);
  const double fall = a.dot(along), rise = b.dot(along);
  if (fall < 0 && rise > 0) {
    const Vec3 n = (rise * a - fall * b).normalized();
    best.lower =
        std::max(best.lower, std::min(n.dot(from), n.dot(to)) - reference::support(solid, n));
  }
  return best;
}

}  // namespace morphe::collision
