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
/// circumscribed facets, so that a set that encloses these encloses the body.
std::vector<Triangle> surface_of(const std::vector<SceneObject>& bodies);

/// Returns `count` points distributed uniformly over the area of triangles, with random numbers
/// that `name` seeds; the vertices if the area is 0.
std::vector<Vec3> sample_area(const std::vector<Triangle>& surface, int count,
                              const std::string& name);

/// Returns the vertices that are extreme in up to 300 directions, sorted, each once.
std::vector<Vec3> outermost_corners(const std::vector<Triangle>& surface);

}  // namespace morphe::cover
