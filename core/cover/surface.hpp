#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/motion/scene.hpp"

namespace morphe::cover {

struct Triangle {
  Vec3 a, b, c;
};

/// The surface of bodies as triangles, in the frame in which they stand (their first pose): those
/// of meshes themselves; cylinders and balls by facets that are circumscribed, so that whatever
/// holds the facets holds the body.
std::vector<Triangle> surface_of(const std::vector<SceneObject>& bodies);

/// Points spread evenly over the area of triangles, the same for the same name.
std::vector<Vec3> sample_area(const std::vector<Triangle>& surface, std::size_t count,
                              const std::string& name);

/// Corners that lie farthest in a few hundred directions: what sticks out most is among them.
std::vector<Vec3> outermost_corners(const std::vector<Triangle>& surface);

}  // namespace morphe::cover
