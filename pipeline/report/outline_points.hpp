#pragma once

#include <vector>

#include "core/motion/scene.hpp"

namespace morphe::report {

/// Returns points of a body, in its frame, whose convex outline represents it from any side (round
/// bodies within 3 % of their radius, a mesh by its convex hull).
std::vector<Vec3> outline_points(const SceneObject& object);

}  // namespace morphe::report
