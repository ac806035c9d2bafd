#pragma once

#include <urdf_model/model.h>

#include <string>

#include "core/files/xml_text.hpp"
#include "core/robot/files/assembly.hpp"

namespace morphe::robot {

/// Converts a pose of urdfdom.
Pose pose_of(const urdf::Pose& pose);

/// Adds capsules that contain a link's collision shapes:
///   sphere     a capsule of length zero
///   cylinder   the smaller of the capsule along it and the sphere around it; with spheres of its
///              radius at both ends, the capsule that they form
///   box        a row of capsules along its longest side
///   mesh       is ignored; the link is listed in assembly.meshes
/// Spheres inside another capsule are omitted. Without `use_shapes`, no capsule is added and no
/// mesh is listed. Throws InputError for a shape without size.
void add_link_shapes(Assembly& assembly, const files::XmlText& text, const urdf::Link& link,
                     int frame, bool use_shapes, const std::string& prefix);

/// Reads the disabled pairs of links of an SRDF: collisions between the capsules of both links are
/// allowed, whichever file the capsules come from. Pairs with an unknown link are noted.
void read_srdf(Assembly& assembly, const FileScope& scope, const std::filesystem::path& file,
               const files::GivenFiles* given);

}  // namespace morphe::robot
