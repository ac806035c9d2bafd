#pragma once

#include "core/motion/scene.hpp"

namespace morphe::collision {

/// Replaces a mesh by the convex hull of its vertices. Returns false if they are coplanar.
bool replace_by_convex_hull(SceneObject& mesh);

}  // namespace morphe::collision
