#pragma once

#include <vector>

#include "core/motion/scene.hpp"

namespace morphe::collision {

/// Returns for each point the index of the first point equal to it.
std::vector<int> first_equal_points(const std::vector<Vec3>& points);

/// Merges the vertices that round to the same micrometre, and removes triangles that degenerate.
void weld(SceneObject& mesh);

/// Fills every hole of a welded mesh whose width 4 A / P is below max_width_m, with A the area of
/// the filling triangles and P the length of the hole's boundary. The width of a circle is its
/// diameter; that of a slit is twice the slit's. Exporters and scanners leave such holes.
void close_holes(SceneObject& mesh, double max_width_m);

}  // namespace morphe::collision
