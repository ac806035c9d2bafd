#pragma once

#include <vector>

#include "core/motion/robot_model.hpp"
#include "core/motion/scene.hpp"

namespace morphe::simulate {

/// The inertial parameters of a rigid body, in its own frame.
struct Inertia {
  double mass = 0;  ///< [kg]
  Vec3 centre_of_mass = Vec3::Zero();
  Eigen::Matrix3d inertia_at_com = Eigen::Matrix3d::Zero();  ///< [kg m^2]
};

/// Returns the inertias [frames] of solid capsules of a density [kg/m^3], because plans.h5 contains
/// no masses. Overlapping volumes count twice. The mass of a frame is at least 1 g.
std::vector<Inertia> robot_inertias(const RobotModel& robot, double density);

/// Returns the inertia of a solid object of uniform density; a mesh counts as its bounding box.
Inertia target_inertia(const SceneObject& object, double mass_kg);

/// Returns the height along the unit vector `up` of an object's lowest point at a pose [m].
double lowest_height(const SceneObject& object, const Pose& pose, const Vec3& up);

}  // namespace morphe::simulate
