#include "stages/simulate/force_prediction.hpp"

#include <algorithm>
#include <cmath>

#include "core/closure/gravity_margin.hpp"
#include "core/collision/distance.hpp"

namespace morphe::simulate {
namespace {

double max_radius(const SceneObject& object, const Vec3& centre) {
  if (object.shape != Shape::mesh) return collision::bounding_radius({object, nullptr});
  double radius = 0;
  for (const Vec3& vertex : object.vertices) radius = std::max(radius, (vertex - centre).norm());
  return radius;
}

/// Returns the greatest acceleration of the lift (minimum_jerk) as a share of that of gravity.
double lift_acceleration_ratio() {
  return 10 / std::sqrt(3.0) * kLiftHeight_m / (kLiftTime_s * kLiftTime_s) / kGravity_m_s2;
}

}  // namespace

RequiredForces required_forces(const PreparedPlan& plan, const Variation& variation) {
  const SceneObject& target = plan.world.scene->objects[plan.world.target];
  const Inertia inertia = target_inertia(target, variation.mass_kg);
  RequiredForces forces;
  double max_N = 0;
  for (const FingerForce& finger : plan.squeeze.finger_forces)
    max_N = std::max(max_N, finger.force_N);
  forces.commanded_N = plan.squeeze.force_scale * max_N;

  closure::ContactSet set;
  set.friction = {variation.friction, variation.torsional_friction_m};
  set.reference = inertia.centre_of_mass;
  set.torque_scale_m = max_radius(target, inertia.centre_of_mass);
  for (const FingerForce& finger : plan.squeeze.finger_forces)
    set.contacts.push_back({finger.point, finger.normal.normalized(), finger.force_N / max_N});
  const closure::Load load{inertia.mass, inertia.centre_of_mass};
  const auto force_N = [&](const Vec3& direction) {
    return closure::gravity_margin(set, load, direction).sufficient_force_n(inertia.mass);
  };
  forces.worst_N = closure::worst_gravity_margin(set, load).sufficient_force_n(inertia.mass);
  const Vec3 down = -(variation.base_from_target.linear().transpose() * plan.world.up);
  forces.gravity_N = force_N(down);
  for (int k = 0; k < std::ssize(forces.along_axes_N); ++k)
    forces.along_axes_N[k] = force_N((k % 2 == 0 ? -1.0 : 1.0) * Vec3::Unit(k / 2));
  // Forces at the centre of mass have no torques, which the lift leaves out (RequiredForces).
  for (closure::Contact& contact : set.contacts) contact.point = set.reference;
  forces.lift_N = (1 + lift_acceleration_ratio()) * force_N(down);
  return forces;
}

}  // namespace morphe::simulate
