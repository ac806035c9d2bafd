#pragma once

#include <string>

#include "core/motion/geometry.hpp"

namespace morphe::setup {

/// A name as YAML reads it back: quoted where it could be a number or a word of YAML.
std::string yaml_name(const std::string& name);
/// Six digits behind the point at most, and no -0.
std::string yaml_number(double value);
std::string yaml_vector(const Vec3& v);  ///< [x, y, z]
/// {position: [x, y, z], quaternion: [w, x, y, z]}
std::string yaml_mount(const Pose& pose);

}  // namespace morphe::setup
