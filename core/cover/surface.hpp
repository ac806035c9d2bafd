#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/motion/scene.hpp"

namespace morphe::cover {

/// A triangle of a surface.
struct Triangle {
  Vec3 a, b, c;
};

/// Returns the surface of bodies as triangles, at their first pose: meshes have their own
/// triangles; cylinders and spheres are approximated by circumscribed facets, so that a set that
/// encloses the facets encloses the body.
std::vector<Triangle> surface_of(const std::vector<SceneObject>& bodies);

/// Returns points distributed uniformly over the area of triangles, deterministic for the same
/// name.
std::vector<Vec3> sample_area(const std::vector<Triangle>& surface, std::size_t count,
                              const std::string& name);

/// Returns the vertices that are extreme in a few hundred directions, which include the most
/// prominent ones.
std::vector<Vec3> outermost_corners(const std::vector<Triangle>& surface);

}  // namespace morphe::cover
