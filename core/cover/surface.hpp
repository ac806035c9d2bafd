#pragma once

#include <string>
#include <vector>

#include "core/motion/scene.hpp"

namespace morphe::cover {

/// A triangle of a surface.
struct Triangle {
  Vec3 a, b, c;
};

/// Returns the surface of bodies, at their first pose, as triangles; cylinders and spheres have
/// circumscribed facets, an even number on each circle, so that a set that encloses these encloses
/// the body.
std::vector<Triangle> surface_of(const std::vector<SceneObject>& bodies, int facets = 24);

/// Returns triangles as a mesh, each with corners of its own.
SceneObject mesh_of(const std::vector<Triangle>& triangles);

/// Returns the sum of the triangles' areas [m²].
double area_of(const std::vector<Triangle>& surface);

/// Returns `count` points distributed uniformly over the area of triangles, with random numbers
/// that `name` seeds; the vertices if the area is 0.
std::vector<Vec3> sample_area(const std::vector<Triangle>& surface, int count,
                              const std::string& name);

/// Returns the vertices that are extreme in up to 300 directions, sorted, each once.
std::vector<Vec3> outermost_corners(const std::vector<Triangle>& surface);

/// Returns the directions of a body's faces and of the edges between them: the normals that most of
/// the area has, and their cross products.
std::vector<Vec3> main_directions(const std::vector<Triangle>& surface);

}  // namespace morphe::cover
