#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "core/collision/mesh_solid.hpp"

namespace morphe::collision {

/// A mesh, made ready if it has no problem.
struct MeshObject : SceneObject {
  std::shared_ptr<const MeshSolid> solid;
  Solid ready() const { return {*this, solid.get()}; }
};

inline MeshObject mesh_object(std::vector<Vec3> vertices, std::vector<Eigen::Vector3i> triangles) {
  MeshObject mesh;
  mesh.name = "mesh";
  mesh.shape = Shape::mesh;
  mesh.time = {0};
  mesh.position = {Vec3::Zero()};
  mesh.orientation = {Quat::Identity()};
  mesh.vertices = std::move(vertices);
  mesh.triangles = std::move(triangles);
  mesh.solid = mesh_solid_of(mesh);
  return mesh;
}

/// The twelve triangles of a box of full size; `walls` 1 … 6 leaves out those that come after.
inline MeshObject box_mesh(const Vec3& size, int walls = 6) {
  std::vector<Vec3> vertices;
  for (int k = 0; k < 8; ++k) {
    vertices.push_back(0.5 * Vec3((k & 1) ? size.x() : -size.x(), (k & 2) ? size.y() : -size.y(),
                                  (k & 4) ? size.z() : -size.z()));
  }
  const std::vector<std::array<int, 4>> sides = {{0, 2, 3, 1}, {0, 1, 5, 4}, {2, 6, 7, 3},
                                                 {0, 4, 6, 2}, {1, 3, 7, 5}, {4, 5, 7, 6}};
  std::vector<Eigen::Vector3i> triangles;
  for (int s = 0; s < walls; ++s) {
    const auto& [a, b, c, d] = sides[static_cast<std::size_t>(s)];
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  }
  return mesh_object(std::move(vertices), std::move(triangles));
}

/// Adds another mesh's triangles, moved.
inline void append(MeshObject& mesh, const SceneObject& other, const Vec3& shift, bool turned) {
  const int first = static_cast<int>(mesh.vertices.size());
  for (const Vec3& vertex : other.vertices) mesh.vertices.push_back(vertex + shift);
  for (Eigen::Vector3i triangle : other.triangles) {
    if (turned) std::swap(triangle[0], triangle[1]);
    mesh.triangles.push_back(triangle + Eigen::Vector3i::Constant(first));
  }
  mesh = mesh_object(mesh.vertices, mesh.triangles);
}

/// A torus about z, closed and not convex.
inline MeshObject torus_mesh(double ring, double tube, int around, int across) {
  std::vector<Vec3> vertices;
  std::vector<Eigen::Vector3i> triangles;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double a = 2 * std::numbers::pi * i / around, b = 2 * std::numbers::pi * j / across;
      const double r = ring + tube * std::cos(b);
      vertices.push_back({r * std::cos(a), r * std::sin(a), tube * std::sin(b)});
      const int here = i * across + j, right = (i + 1) % around * across + j;
      const int up = i * across + (j + 1) % across,
                both = (i + 1) % around * across + (j + 1) % across;
      triangles.push_back({here, right, both});
      triangles.push_back({here, both, up});
    }
  }
  return mesh_object(std::move(vertices), std::move(triangles));
}

}  // namespace morphe::collision
