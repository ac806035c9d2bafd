#include "stages/verify/separation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace morphe::verify {
namespace {

/// Returns the squared distance of a point to a segment, the minimum of a clamped parabola.
double point_segment_squared(const Vec3& point, const Vec3& from, const Vec3& along,
                             double length_squared) {
  const Vec3 offset = point - from;
  const double share =
      length_squared > 0 ? std::clamp(offset.dot(along) / length_squared, 0.0, 1.0) : 0.0;
  return (offset - share * along).squaredNorm();
}

/// Returns the signed distance in the half-plane of a body of revolution to the rectangle [0,
/// radius] x [-half, half].
double rectangle(double across, double along) {
  const double outside = std::hypot(std::max(across, 0.0), std::max(along, 0.0));
  return outside + std::min(std::max(across, along), 0.0);
}

}  // namespace

double segment_distance(const Segment& a, const Segment& b) {
  const Vec3 along_a = a.to - a.from, along_b = b.to - b.from, offset = a.from - b.from;
  const double aa = along_a.squaredNorm(), bb = along_b.squaredNorm(), ab = along_a.dot(along_b);
  double best = point_segment_squared(a.from, b.from, along_b, bb);
  best = std::min(best, point_segment_squared(a.to, b.from, along_b, bb));
  best = std::min(best, point_segment_squared(b.from, a.from, along_a, aa));
  best = std::min(best, point_segment_squared(b.to, a.from, along_a, aa));
  const double determinant = aa * bb - ab * ab;
  if (determinant > 1e-14 * aa * bb) {
    const double a_offset = along_a.dot(offset), b_offset = along_b.dot(offset);
    const double u = (ab * b_offset - bb * a_offset) / determinant;
    const double v = (aa * b_offset - ab * a_offset) / determinant;
    if (u > 0 && u < 1 && v > 0 && v < 1)
      best = std::min(best, (offset + u * along_a - v * along_b).squaredNorm());
  }
  return std::sqrt(best);
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
      return rectangle(std::hypot(point.x(), point.y()) - size[0],
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
  const auto at = [&](double s) { return signed_distance(solid, segment.from + s * along); };
  // The signed distance changes by at most the distance between the points.
  const double bound = at(0.5) - 0.5 * length;
  if (bound >= enough) return bound;

  constexpr double kGolden = std::numbers::phi - 1;
  double low = 0, high = 1;
  double inner_low = 1 - kGolden, inner_high = kGolden;
  double value_low = at(inner_low), value_high = at(inner_high);
  constexpr int kMaxGoldenSectionSteps = 100;  // enough to exhaust double precision
  for (int step = 0; step < kMaxGoldenSectionSteps && (high - low) * length > 1e-9; ++step) {
    if (value_low < value_high) {
      high = inner_high;
      inner_high = inner_low;
      value_high = value_low;
      inner_low = high - kGolden * (high - low);
      value_low = at(inner_low);
    } else {
      low = inner_low;
      inner_low = inner_high;
      value_low = value_high;
      inner_high = low + kGolden * (high - low);
      value_high = at(inner_high);
    }
  }
  return std::min({value_low, value_high, at(0), at(1)});
}

bool has_valid_shape(const SceneObject& solid) {
  constexpr std::size_t kSizes[] = {1, 3, 2, 2};
  if (solid.shape == Shape::mesh) {
    const int vertices = static_cast<int>(solid.vertices.size());
    const auto exists = [&](const Eigen::Vector3i& t) {
      return t.minCoeff() >= 0 && t.maxCoeff() < vertices;
    };
    const auto corner = [&](const Eigen::Vector3i& t, int k) -> const Vec3& {
      return solid.vertices[t[k]];
    };
    const auto wide = [&](const Eigen::Vector3i& t) {
      return corner(t, 0) != corner(t, 1) && corner(t, 1) != corner(t, 2) &&
             corner(t, 2) != corner(t, 0);
    };
    return std::ranges::all_of(solid.vertices, [](const Vec3& v) { return v.allFinite(); }) &&
           std::ranges::all_of(solid.triangles, exists) &&
           std::ranges::any_of(solid.triangles, wide);
  }
  return solid.size.size() == kSizes[static_cast<std::size_t>(solid.shape)] &&
         std::all_of(solid.size.begin(), solid.size.end(), [](double x) { return x > 0; });
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
