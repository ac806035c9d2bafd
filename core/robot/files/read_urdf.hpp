#pragma once

#include <urdf_model/model.h>

#include <map>
#include <string>
#include <vector>

#include "core/files/xml_text.hpp"
#include "core/robot/files/assembly.hpp"

namespace morphe::robot {

/// Converts a pose of urdfdom.
Pose pose_of(const urdf::Pose& pose);

/// Adds capsules that contain a link's collision shapes: a sphere becomes a capsule of length zero,
/// a cylinder the smaller of the capsule along it and the sphere around it, a box a row of capsules
/// along its longest side. A cylinder with a sphere of its radius at both ends becomes the capsule
/// that they form. Meshes are ignored and their links are listed in assembly.meshes; without
/// `use_shapes` all shapes are ignored and not listed.
void add_link_shapes(Assembly& assembly, const files::XmlText& text, const urdf::Link& link,
                     int frame, bool use_shapes, const std::string& prefix);

/// Reads the disabled pairs of links of an SRDF: collisions between the capsules of the two links
/// are allowed, whichever file they come from. Pairs with links that the URDF lacks are noted.
void read_srdf(Assembly& assembly, const FileScope& scope, const std::filesystem::path& file);

}  // namespace morphe::robot
