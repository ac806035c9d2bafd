#include "core/cover/surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/cover/constants.hpp"
#include "core/math/random_stream.hpp"

namespace morphe::cover {
namespace {

void add_quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
              std::vector<Triangle>& out) {
  out.push_back({a, b, c});
  out.push_back({a, c, d});
}

void add_box(const Pose& pose, const Vec3& half, std::vector<Triangle>& out) {
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 n = half[axis] * Vec3::Unit(axis),
               u = half[(axis + 1) % 3] * Vec3::Unit((axis + 1) % 3),
               v = half[(axis + 2) % 3] * Vec3::Unit((axis + 2) % 3);
    for (const double side : {1.0, -1.0}) {
      add_quad(pose * (side * n + u + v), pose * (side * n - u + v), pose * (side * n - u - v),
               pose * (side * n + u - v), out);
    }
  }
}

/// Adds a surface of revolution about z through (radius, height) points.
void add_revolution_surface(const Pose& pose, const std::vector<Eigen::Vector2d>& profile,
                            int facets, std::vector<Triangle>& out) {
  // Facets are tangent to the circle.
  const double wider = 1 / std::cos(std::numbers::pi / facets);
  const auto point = [&](int i, int k) -> Vec3 {
    const Eigen::Vector2d& p = profile[i];
    const double angle = 2 * std::numbers::pi * k / facets;
    return pose * Vec3(wider * p.x() * std::cos(angle), wider * p.x() * std::sin(angle), p.y());
  };
  for (int i = 0; i + 1 < std::ssize(profile); ++i) {
    for (int k = 0; k < facets; ++k) {
      add_quad(point(i, k), point(i, k + 1), point(i + 1, k + 1), point(i + 1, k), out);
    }
  }
}

/// Returns the profile of a sphere whose two halves are `length` apart.
std::vector<Eigen::Vector2d> sphere_profile(double radius, double length, int facets) {
  const int half_facets = facets / 2;
  const double wider = 1 / std::cos(std::numbers::pi / (2 * half_facets));
  std::vector<Eigen::Vector2d> profile;
  for (int k = 0; k <= half_facets; ++k) {
    const double polar = std::numbers::pi * k / half_facets;
    const double half = (2 * k < half_facets ? 0.5 : -0.5) * length;
    if (2 * k == half_facets) profile.emplace_back(wider * radius, 0.5 * length);
    profile.emplace_back(wider * radius * std::sin(polar), half + wider * radius * std::cos(polar));
  }
  return profile;
}

void add(const SceneObject& body, int facets, std::vector<Triangle>& out) {
  const Pose pose =
      body.position.empty() ? Pose::Identity() : make_pose(body.position[0], body.orientation[0]);
  const auto& size = body.size;
  if (body.shape == Shape::sphere)
    return add_revolution_surface(pose, sphere_profile(size[0], 0, facets), facets, out);
  if (body.shape == Shape::capsule)
    return add_revolution_surface(pose, sphere_profile(size[0], size[1], facets), facets, out);
  if (body.shape == Shape::box) return add_box(pose, 0.5 * Vec3(size[0], size[1], size[2]), out);
  if (body.shape == Shape::cylinder) {
    const double radius = size[0], half = 0.5 * size[1];
    const std::vector<Eigen::Vector2d> profile{
        {0, half}, {radius, half}, {radius, -half}, {0, -half}};
    return add_revolution_surface(pose, profile, facets, out);
  }
  for (const Eigen::Vector3i& t : body.triangles) {
    const auto corner = [&](int k) -> Vec3 { return pose * body.vertices[t[k]]; };
    out.push_back({corner(0), corner(1), corner(2)});
  }
}

}  // namespace

std::vector<Triangle> surface_of(const std::vector<SceneObject>& bodies, int facets) {
  std::vector<Triangle> surface;
  for (const SceneObject& body : bodies) add(body, facets, surface);
  return surface;
}

SceneObject mesh_of(const std::vector<Triangle>& triangles) {
  SceneObject mesh;
  mesh.shape = Shape::mesh;
  mesh.position = {Vec3::Zero()};
  mesh.orientation = {Quat::Identity()};
  for (const Triangle& t : triangles) {
    const int first = static_cast<int>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {t.a, t.b, t.c});
    mesh.triangles.emplace_back(first, first + 1, first + 2);
  }
  return mesh;
}

double area_of(const std::vector<Triangle>& surface) {
  double sum = 0;
  for (const Triangle& t : surface) sum += 0.5 * (t.b - t.a).cross(t.c - t.a).norm();
  return sum;
}

std::vector<Vec3> sample_area(const std::vector<Triangle>& surface, int count,
                              const std::string& name) {
  std::vector<double> area_up_to;  // the sum of the areas of a triangle and those before it
  double sum = 0;
  for (const Triangle& t : surface) {
    sum += 0.5 * (t.b - t.a).cross(t.c - t.a).norm();
    area_up_to.push_back(sum);
  }
  std::vector<Vec3> points;
  if (!(sum > 0)) {  // for a degenerate surface only the vertices remain
    for (const Triangle& t : surface) points.insert(points.end(), {t.a, t.b, t.c});
    return points;
  }
  math::RandomStream random(1, name);
  points.reserve(count);
  for (int k = 0; k < count; ++k) {
    // Stratified along the area, random within a triangle.
    const double area = sum * (k + random.uniform()) / count;
    const auto found = std::ranges::upper_bound(area_up_to, area);
    const Triangle& t = surface[std::min(found - area_up_to.begin(), std::ssize(area_up_to) - 1)];
    double u = random.uniform(), v = random.uniform();
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    points.emplace_back(t.a + u * (t.b - t.a) + v * (t.c - t.a));
  }
  return points;
}

std::vector<Vec3> outermost_corners(const std::vector<Triangle>& surface) {
  std::vector<Vec3> corners;
  if (surface.empty()) return corners;
  const int directions = static_cast<int>(std::clamp<std::ptrdiff_t>(
      kCornerProducts / std::ssize(surface), kMinDirections, kMaxDirections));
  for (int k = 0; k < directions; ++k) {  // along a spiral on the sphere
    const double z = 1 - (2 * k + 1.0) / directions, azimuth = 2.399963229728653 * k;
    const double r = std::sqrt(1 - z * z);
    const Vec3 direction(r * std::cos(azimuth), r * std::sin(azimuth), z);
    Vec3 farthest = surface.front().a;
    for (const Triangle& t : surface) {
      for (const Vec3& corner : {t.a, t.b, t.c})
        if (corner.dot(direction) > farthest.dot(direction)) farthest = corner;
    }
    corners.push_back(farthest);
  }
  std::ranges::sort(corners, [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  });
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

std::vector<Vec3> main_directions(const std::vector<Triangle>& surface) {
  std::vector<Vec3> sums;  // area times normal, of triangles with about the same normal or opposite
  for (const Triangle& t : surface) {
    const Vec3 normal = 0.5 * (t.b - t.a).cross(t.c - t.a);
    const auto same = std::ranges::find_if(sums, [&](const Vec3& sum) {
      return std::abs(sum.dot(normal)) > kSameNormalCosine * sum.norm() * normal.norm();
    });
    if (same == sums.end())
      sums.push_back(normal);
    else
      *same += same->dot(normal) > 0 ? normal : Vec3(-normal);
  }
  std::ranges::stable_sort(sums, std::greater<>(), [](const Vec3& sum) { return sum.norm(); });
  if (std::ssize(sums) > kMaxMainNormals) sums.resize(kMaxMainNormals);
  std::vector<Vec3> directions;
  const auto add = [&](const Vec3& direction) {
    const auto same = [&](const Vec3& other) {
      return std::abs(other.dot(direction.normalized())) > kSameNormalCosine;
    };
    if (direction.norm() > kMinCross && std::ranges::none_of(directions, same))
      directions.push_back(direction.normalized());
  };
  for (const Vec3& sum : sums) {
    if (sum.norm() > 0) add(sum.normalized());
  }
  const std::size_t normals = directions.size();
  for (std::size_t i = 0; i < normals; ++i)
    for (std::size_t k = 0; k < i; ++k) add(directions[i].cross(directions[k]));
  return directions;
}

}  // namespace morphe::cover
