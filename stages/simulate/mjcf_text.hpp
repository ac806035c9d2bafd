#pragma once

#include <string>
#include <vector>

#include "core/motion/robot_model.hpp"
#include "core/motion/scene.hpp"
#include "stages/simulate/inertias.hpp"
#include "stages/simulate/options.hpp"
#include "stages/simulate/servos.hpp"

namespace morphe::simulate {

/// The parameters that differ between the models of one plan.
struct Variation {
  double friction = 0, torsional_friction_m = 0, mass_kg = 0;
  Pose base_from_target = Pose::Identity();
};

/// A robot and its target on a support, in the frame of the robot's base.
struct SimulatedWorld {
  const RobotModel* robot = nullptr;
  std::vector<Servo> servos;      ///< [joints]
  std::vector<Inertia> inertias;  ///< [frames]
  const Scene* scene = nullptr;
  int target = -1;  ///< index in scene->objects
  Vec3 up = Vec3::UnitZ();
  bool lifts_base = false;  ///< true for a hand without an arm, whose base slides along `up`
};

/// The environment of the target: `scene` with its support and the surrounding objects; `none` for
/// a target that is held by the hand alone, without weight, support and surrounding objects.
enum class Environment { scene, none };

/// Returns true if an object is part of the model in addition to the target. Objects that move are
/// excluded, and so are meshes, whose convex hull would fill a shelf. The trajectory is certified
/// to be clear of them.
bool is_static_obstacle(const SimulatedWorld& world, std::size_t object);

/// Returns the model as MJCF, every number with 17 digits. Names: frame k is body and joint "f<k>"
/// (whose value is ratio * q + offset), joint j has the motor "m<j>", capsule k is geom "c<k>";
/// "target" is body and geom; "base" is body, joint and motor of a base that is lifted; object k is
/// geom "o<k>"; "support" is the plane that supports the target, through its lowest point and
/// normal to `up`.
/// Contacts are listed pair by pair, because unlisted pairs would combine friction by the larger of
/// two values: the target with every capsule, with the support and with every surrounding object
/// except the one called "table", which is replaced by the support; the hand's capsules with each
/// other, unless their collision is allowed, and with all these objects. A target's mesh counts as
/// its convex hull.
std::string mjcf_text(const SimulatedWorld& world, const Variation& variation,
                      const SimulateOptions& options, Environment around);

}  // namespace morphe::simulate
