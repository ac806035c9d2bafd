#pragma once

#include <string>

#include "core/motion/geometry.hpp"

namespace morphe::robot {

/// Returns three numbers as in a URDF, such that they are read without loss.
std::string urdf_numbers(const Vec3& vector);
/// Returns the `origin` element of a pose.
std::string urdf_origin(const Pose& pose);

}  // namespace morphe::robot
