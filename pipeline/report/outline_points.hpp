#pragma once

#include <vector>

#include "core/motion/scene.hpp"

namespace morphe::report {

/// Returns points of a body in its frame. The convex hull of their projection is the body's outline
/// from any side: of round bodies within 3 % of their radius, of a mesh without its concavities.
std::vector<Vec3> outline_points(const SceneObject& object);

}  // namespace morphe::report
