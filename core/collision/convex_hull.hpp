#pragma once

#include "core/motion/scene.hpp"

namespace morphe::collision {

/// Replaces a mesh by the convex hull of its vertices. Returns false, and leaves the mesh as it is,
/// if they are fewer than four or coplanar.
bool replace_by_convex_hull(SceneObject& mesh);

}  // namespace morphe::collision
