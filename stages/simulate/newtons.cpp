#include "stages/simulate/newtons.hpp"

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

/// Of 10 s^3 - 15 s^4 + 6 s^5 over kLift_s, over gravity.
double lift_share() { return 10 / std::sqrt(3.0) * kLift_m / (kLift_s * kLift_s) / kGravity; }

}  // namespace

Newtons newtons_of(const PreparedPlan& plan, const Variation& variation) {
  const SceneObject& target =
      plan.world.scene->objects[static_cast<std::size_t>(plan.world.target)];
  const Inertia inertia = target_inertia(target, variation.mass_kg);
  Newtons newtons;
  double most = 0;
  for (const Press& press : plan.squeeze.presses) most = std::max(most, press.force_N);
  newtons.given = plan.squeeze.force_share * most;

  closure::ContactSet set;
  set.friction = {variation.friction, variation.torsion_m};
  set.reference = inertia.centre;
  set.torque_scale_m = reach_of(target, inertia.centre);
  for (const Press& press : plan.squeeze.presses)
    set.contacts.push_back({press.point, press.inward.normalized(), press.force_N / most});
  const closure::Load load{inertia.mass, inertia.centre};
  const auto needed = [&](const Vec3& direction) {
    return closure::gravity_margin(set, load, direction).newtons_enough(inertia.mass);
  };
  newtons.worst = closure::worst_gravity_margin(set, load).newtons_enough(inertia.mass);
  const Vec3 down = -(variation.base_from_target.linear().transpose() * plan.world.up);
  newtons.down = needed(down);
  for (std::size_t k = 0; k < newtons.along.size(); ++k)
    newtons.along[k] = needed((k % 2 == 0 ? -1.0 : 1.0) * Vec3::Unit(static_cast<int>(k) / 2));
  for (closure::Contact& contact : set.contacts) contact.point = set.reference;
  newtons.lift = (1 + lift_share()) * needed(down);
  return newtons;
}

}  // namespace morphe::simulate
