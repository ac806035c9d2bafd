#pragma once

#include "core/motion/scene.hpp"

namespace morphe::collision {

/// Merges vertices within the same micrometre into the first of them, and removes triangles that
/// degenerate.
void weld(SceneObject& mesh);

/// Fills every hole whose width 4 A / P is below widest_m, with A the area of the filling triangles
/// and P the length of the hole's boundary (for a circle this is the diameter, for a slit twice its
/// width). Exporters and scanners leave such holes at missing triangles and open seams. The mesh
/// must be welded.
void close_holes(SceneObject& mesh, double widest_m);

}  // namespace morphe::collision
