#pragma once

#include <vector>

#include "core/motion/robot_table.hpp"
#include "core/motion/scene.hpp"

namespace morphe::simulate {

/// What a rigid body weighs, in its own frame.
struct Inertia {
  double mass = 0;  ///< [kg]
  Vec3 centre = Vec3::Zero();
  Eigen::Matrix3d about_centre = Eigen::Matrix3d::Zero();  ///< [kg m^2]
};

/// [frames] plans.h5 knows no masses: every capsule is solid, of that density, and what overlaps
/// counts twice. A frame without a capsule weighs 1 g.
std::vector<Inertia> robot_inertias(const RobotTable& robot, double density);

/// Solid, of uniform density, its centre of mass in its centre; a mesh as the box around it.
Inertia target_inertia(const SceneObject& object, double mass_kg);

/// The lowest point's height along `up` of a body at a pose [m].
double lowest(const SceneObject& object, const Pose& pose, const Vec3& up);

}  // namespace morphe::simulate
