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

/// Returns the inertias of the robot's frames. plans.h5 contains no masses, so every capsule is
/// taken as solid with the given density, and overlapping volumes count twice. A frame without a
/// capsule has a mass of 1 g. [frames]
std::vector<Inertia> robot_inertias(const RobotModel& robot, double density);

/// Returns the inertia of a solid body of uniform density with the centre of mass in its centre; a
/// mesh is approximated by its bounding box.
Inertia target_inertia(const SceneObject& object, double mass_kg);

/// Returns the height of the lowest point of a body at a pose, along `up` [m].
double lowest_height(const SceneObject& object, const Pose& pose, const Vec3& up);

}  // namespace morphe::simulate
