#pragma once

#include "core/motion/scene.hpp"

namespace morphe::collision {

/// Makes a mesh the convex hull of its vertices. False if they lie in a plane.
bool take_hull(SceneObject& mesh);

}  // namespace morphe::collision
