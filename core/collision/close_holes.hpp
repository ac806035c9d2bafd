#pragma once

#include "core/motion/scene.hpp"

namespace morphe::collision {

/// Makes one vertex of all within the same micrometre (the first of them), and drops triangles that
/// are none then.
void weld(SceneObject& mesh);

/// Puts a lid on every hole that nothing wider fits through: 4 A / P < widest_m, with A the area of
/// the lid and P the length of the rim (of a circle the diameter, of a slit twice its width).
/// Exporters and scanners leave such holes where a triangle is missing or a seam was not sewn. The
/// mesh must be welded.
void close_holes(SceneObject& mesh, double widest_m);

}  // namespace morphe::collision
