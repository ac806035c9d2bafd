#pragma once

#include <vector>

#include "core/motion/scene.hpp"

namespace morphe::report {

/// Points of a body, in its frame, around which a convex outline shows it from any side (round ones
/// within 3 % of their radius; a mesh by its hull).
std::vector<Vec3> outline_points(const SceneObject& object);

}  // namespace morphe::report
