#include "stages/verify/separation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace morphe::verify {
namespace {

double point_segment_squared(const Vec3& point, const Vec3& from, const Vec3& along,
                             double length_squared) {
  const Vec3 difference = point - from;
  const double share =
      length_squared > 0 ? std::clamp(difference.dot(along) / length_squared, 0.0, 1.0) : 0.0;
  return (difference - share * along).squaredNorm();
}

/// Returns the signed distance of a point this far beyond (< 0: inside) the sides of a rectangle.
double rectangle_distance(double across, double along) {
  const double outside = std::hypot(std::max(across, 0.0), std::max(along, 0.0));
  return outside + std::min(std::max(across, along), 0.0);
}

}  // namespace

double segment_distance(const Segment& a, const Segment& b) {
  const Vec3 along_a = a.to - a.from, along_b = b.to - b.from, gap = a.from - b.from;
  const double aa = along_a.squaredNorm(), bb = along_b.squaredNorm(), ab = along_a.dot(along_b);
  double least = point_segment_squared(a.from, b.from, along_b, bb);
  least = std::min(least, point_segment_squared(a.to, b.from, along_b, bb));
  least = std::min(least, point_segment_squared(b.from, a.from, along_a, aa));
  least = std::min(least, point_segment_squared(b.to, a.from, along_a, aa));
  const double determinant = aa * bb - ab * ab;
  if (determinant > 1e-14 * aa * bb) {
    const double a_offset = along_a.dot(gap), b_offset = along_b.dot(gap);
    const double u = (ab * b_offset - bb * a_offset) / determinant;
    const double v = (aa * b_offset - ab * a_offset) / determinant;
    if (u > 0 && u < 1 && v > 0 && v < 1)
      least = std::min(least, (gap + u * along_a - v * along_b).squaredNorm());
  }
  return std::sqrt(least);
}

double signed_distance(const SceneObject& solid, const Vec3& point) {
  const auto& size = solid.size;
  switch (solid.shape) {
    case Shape::sphere:
      return point.norm() - size[0];
    case Shape::box: {
      const Vec3 beyond = point.cwiseAbs() - 0.5 * Vec3(size[0], size[1], size[2]);
      return beyond.cwiseMax(0.0).norm() + std::min(beyond.maxCoeff(), 0.0);
    }
    case Shape::cylinder:
      return rectangle_distance(std::hypot(point.x(), point.y()) - size[0],
                                std::abs(point.z()) - 0.5 * size[1]);
    case Shape::capsule: {
      const double beyond = std::max(std::abs(point.z()) - 0.5 * size[1], 0.0);
      return Vec3(point.x(), point.y(), beyond).norm() - size[0];
    }
    case Shape::mesh:
      break;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double segment_solid_distance(const SceneObject& solid, const Segment& segment, double enough) {
  const Vec3 along = segment.to - segment.from;
  const double length = along.norm();
  const auto distance = [&](double s) { return signed_distance(solid, segment.from + s * along); };
  // The signed distance changes by at most the distance between the points.
  const double bound = distance(0.5) - 0.5 * length;
  if (bound >= enough) return bound;

  constexpr double kGolden = std::numbers::phi - 1;
  double low = 0, high = 1;
  double inner_low = 1 - kGolden, inner_high = kGolden;
  double value_low = distance(inner_low), value_high = distance(inner_high);
  constexpr int kMaxGoldenSectionSteps = 100;  // enough to exhaust double precision
  for (int step = 0; step < kMaxGoldenSectionSteps && (high - low) * length > 1e-9; ++step) {
    if (value_low < value_high) {
      high = inner_high;
      inner_high = inner_low;
      value_high = value_low;
      inner_low = high - kGolden * (high - low);
      value_low = distance(inner_low);
    } else {
      low = inner_low;
      inner_low = inner_high;
      value_low = value_high;
      inner_high = low + kGolden * (high - low);
      value_high = distance(inner_high);
    }
  }
  return std::min({value_low, value_high, distance(0), distance(1)});
}

bool has_valid_shape(const SceneObject& solid) {
  constexpr std::size_t kSizeCounts[] = {1, 3, 2, 2};
  if (solid.shape == Shape::mesh) {
    const std::vector<Vec3>& vertices = solid.vertices;
    const auto exists = [&](const Eigen::Vector3i& t) {
      return t.minCoeff() >= 0 && t.maxCoeff() < std::ssize(vertices);
    };
    const auto has_edges = [&](const Eigen::Vector3i& t) {
      const Vec3 &a = vertices[t[0]], &b = vertices[t[1]], &c = vertices[t[2]];
      return a != b && b != c && c != a;
    };
    return std::ranges::all_of(vertices, [](const Vec3& v) { return v.allFinite(); }) &&
           std::ranges::all_of(solid.triangles, exists) &&
           std::ranges::any_of(solid.triangles, has_edges);
  }
  return solid.size.size() == kSizeCounts[static_cast<std::size_t>(solid.shape)] &&
         std::ranges::all_of(solid.size, [](double x) { return x > 0; });
}

double bounding_radius(const SceneObject& solid) {
  const auto& size = solid.size;
  switch (solid.shape) {
    case Shape::sphere:
      return size[0];
    case Shape::box:
      return 0.5 * Vec3(size[0], size[1], size[2]).norm();
    case Shape::cylinder:
      return std::hypot(size[0], 0.5 * size[1]);
    case Shape::capsule:
      return size[0] + 0.5 * size[1];
    case Shape::mesh:
      break;
  }
  double radius = 0;
  for (const Vec3& vertex : solid.vertices) radius = std::max(radius, vertex.norm());
  return radius;
}

}  // namespace morphe::verify
