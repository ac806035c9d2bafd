#include "stages/simulate/force_prediction.hpp"

#include <algorithm>
#include <cmath>

#include "core/closure/gravity_margin.hpp"
#include "core/collision/distance.hpp"
#include "core/math/rotation.hpp"

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

double force_for_weight_N(const closure::ContactSet& set, const Inertia& inertia,
                          const Vec3& direction) {
  return closure::gravity_margin(set, {inertia.mass, inertia.centre_of_mass}, direction)
      .sufficient_force_n(inertia.mass);
}
/// Returns the force that balances the weight if contacts at the centre of mass leave no torques.
double force_without_torques_N(closure::ContactSet set, const Inertia& inertia,
                               const Vec3& direction) {
  for (closure::Contact& contact : set.contacts) contact.point = set.reference;
  return force_for_weight_N(set, inertia, direction);
}

/// Returns the force for the loads of a target that is carried. It may turn in the hand by
/// kMaxInHandDisplacement_deg. A load whose direction in the target has turned by less since the
/// grasp must be balanced without its torques, as during the lift; one that has turned farther,
/// with its torques after it has turned back by this angle.
double carrying_force_N(const closure::ContactSet& set, const Inertia& inertia,
                        const std::vector<CarriedLoad>& loads) {
  constexpr double kFree_rad = kMaxInHandDisplacement_deg * kRadPerDegree;
  const Vec3 first = loads.front().normalized();
  double max_N = 0;
  for (const CarriedLoad& load : loads) {
    const double load_m_s2 = load.norm();
    if (!(load_m_s2 > 0)) continue;
    const Vec3 direction = load / load_m_s2;
    const double share = load_m_s2 / kGravity_m_s2;
    max_N = std::max(max_N, share * force_without_torques_N(set, inertia, direction));
    const Eigen::AngleAxisd turn(math::shortest_rotation(direction, first));
    if (turn.angle() <= kFree_rad) continue;
    const Vec3 turned_back = Eigen::AngleAxisd(kFree_rad, turn.axis()) * direction;
    max_N = std::max(max_N, share * force_for_weight_N(set, inertia, turned_back));
  }
  return max_N;
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
  forces.worst_N = closure::worst_gravity_margin(set, load).sufficient_force_n(inertia.mass);
  const Vec3 down = -(variation.base_from_target.linear().transpose() * plan.world.up);
  forces.gravity_N = force_for_weight_N(set, inertia, down);
  for (int k = 0; k < std::ssize(forces.along_axes_N); ++k)
    forces.along_axes_N[k] =
        force_for_weight_N(set, inertia, (k % 2 == 0 ? -1.0 : 1.0) * Vec3::Unit(k / 2));
  forces.lift_N =
      plan.task ? carrying_force_N(set, inertia, plan.task->loads)
                : (1 + lift_acceleration_ratio()) * force_without_torques_N(set, inertia, down);
  return forces;
}

}  // namespace morphe::simulate
