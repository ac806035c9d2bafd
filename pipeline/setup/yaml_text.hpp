#pragma once

#include <string>

#include "core/motion/geometry.hpp"

namespace morphe::setup {

/// Returns a text in lower case letters.
std::string lower_case(std::string text);
/// Returns a text as YAML in quotes.
std::string yaml_text(const std::string& text);
/// Returns a name as YAML: quoted unless it is a plain identifier and no keyword.
std::string yaml_name(const std::string& name);
/// Returns a number with at most six decimals, and 0 for -0.
std::string yaml_number(double value);
/// Returns [x, y, z].
std::string yaml_vector(const Vec3& v);
/// Returns {position: [x, y, z], quaternion: [w, x, y, z]}.
std::string yaml_mount(const Pose& pose);

}  // namespace morphe::setup
