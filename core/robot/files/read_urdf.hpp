#pragma once

#include <urdf_model/model.h>

#include <map>
#include <string>
#include <vector>

#include "core/files/xml_text.hpp"
#include "core/robot/files/assembly.hpp"

namespace morphe::robot {

Pose pose_of(const urdf::Pose& pose);

/// Adds a link's collision shapes as capsules that hold them: a sphere is one, a cylinder the
/// smaller of the capsule along it and the sphere around it, a box a row of capsules along its
/// longest side. A cylinder with a sphere of its radius at both ends is the capsule they make up.
/// Meshes are left out and their links named in assembly.meshes; without `use_shapes` all is,
/// unnamed.
void add_link_shapes(Assembly& assembly, const files::XmlText& text, const urdf::Link& link,
                     int frame, bool use_shapes, const std::string& prefix);

/// The links' disabled pairs of an SRDF: no capsule of the one collides with one of the other,
/// whichever file they come from. Pairs of links that the URDF lacks are noted.
void read_srdf(Assembly& assembly, const FileScope& scope, const std::filesystem::path& file);

}  // namespace morphe::robot
