#pragma once

#include <string>

#include "core/motion/robot_model.hpp"
#include "core/motion/scene.hpp"
#include "stages/simulate/inertias.hpp"

namespace morphe::simulate {

/// Contacts are taken only from the list of pairs, masses only from <inertial>.
inline constexpr const char* kGeomAttributes = "contype=\"0\" conaffinity=\"0\" mass=\"0\"";

// Elements and attributes of MJCF; numbers have 17 digits.

/// Returns three numbers, separated by blanks.
std::string numbers(const Vec3& v);
/// Returns the attributes pos and quat.
std::string pose_attributes(const Pose& pose);
/// Returns the element of a body's mass and inertia.
std::string inertial(const Inertia& body);
/// Returns the geom of a capsule with index k.
std::string capsule_geom(const RobotModel::Capsule& capsule, int k);
/// Returns the geom of an object; the mesh of a mesh object has the name of the geom.
std::string object_geom(const SceneObject& object, const std::string& name, const Pose& pose);

}  // namespace morphe::simulate
