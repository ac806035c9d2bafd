#include "stages/simulate/force_prediction.hpp"

#include <algorithm>
#include <cmath>

#include "core/closure/gravity_margin.hpp"
#include "core/collision/distance.hpp"

namespace morphe::simulate {
namespace {

double reach_of(const SceneObject& object, const Vec3& centre) {
  if (object.shape != Shape::mesh) return collision::bounding_radius({object, nullptr});
  double reach = 0;
  for (const Vec3& vertex : object.vertices) reach = std::max(reach, (vertex - centre).norm());
  return reach;
}

/// Returns the greatest acceleration of 10 s^3 - 15 s^4 + 6 s^5 over kLiftTime_s, divided by
/// gravity.
double lift_share() {
  return 10 / std::sqrt(3.0) * kLiftHeight_m / (kLiftTime_s * kLiftTime_s) / kGravity_m_s2;
}

}  // namespace

PredictedForces predict_forces(const PreparedPlan& plan, const Variation& variation) {
  const SceneObject& target = plan.world.scene->objects[plan.world.target];
  const Inertia inertia = target_inertia(target, variation.mass_kg);
  PredictedForces predicted;
  double most = 0;
  for (const FingerForce& press : plan.squeeze.finger_forces) most = std::max(most, press.force_N);
  predicted.commanded_N = plan.squeeze.force_scale * most;

  closure::ContactSet set;
  set.friction = {variation.friction, variation.torsional_friction_m};
  set.reference = inertia.centre_of_mass;
  set.torque_scale_m = reach_of(target, inertia.centre_of_mass);
  for (const FingerForce& press : plan.squeeze.finger_forces)
    set.contacts.push_back({press.point, press.normal.normalized(), press.force_N / most});
  const closure::Load load{inertia.mass, inertia.centre_of_mass};
  const auto needed = [&](const Vec3& direction) {
    return closure::gravity_margin(set, load, direction).sufficient_force_n(inertia.mass);
  };
  predicted.worst_N = closure::worst_gravity_margin(set, load).sufficient_force_n(inertia.mass);
  const Vec3 down = -(variation.base_from_target.linear().transpose() * plan.world.up);
  predicted.gravity_N = needed(down);
  for (std::size_t k = 0; k < predicted.along_axes_N.size(); ++k)
    predicted.along_axes_N[k] =
        needed((k % 2 == 0 ? -1.0 : 1.0) * Vec3::Unit(static_cast<int>(k) / 2));
  for (closure::Contact& contact : set.contacts) contact.point = set.reference;
  predicted.lift_N = (1 + lift_share()) * needed(down);
  return predicted;
}

}  // namespace morphe::simulate
