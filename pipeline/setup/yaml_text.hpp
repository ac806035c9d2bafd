#pragma once

#include <string>

#include "core/motion/geometry.hpp"

namespace morphe::setup {

/// Returns a name that YAML reads as the same text: quoted if it could be read as a number or a
/// keyword of YAML.
std::string yaml_name(const std::string& name);
/// Formats a number with at most six decimals and without -0.
std::string yaml_number(double value);
/// Returns [x, y, z].
std::string yaml_vector(const Vec3& v);
/// Returns {position: [x, y, z], quaternion: [w, x, y, z]}.
std::string yaml_mount(const Pose& pose);

}  // namespace morphe::setup
