#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/motion/robot_model.hpp"
#include "core/motion/scene.hpp"
#include "stages/simulate/inertias.hpp"
#include "stages/simulate/options.hpp"
#include "stages/simulate/servos.hpp"
#include "stages/simulate/support.hpp"

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
  std::optional<Support> support{};  ///< absent: a plane through the target's lowest point
  std::vector<Vec3> feet{};          ///< of the target, in its frame; used if it has a support
};

/// The surroundings of target and hand: support, static obstacles and gravity (scene), or no such
/// thing (none).
enum class Environment { scene, none };

/// Returns true if an object is part of the model in addition to the target. It is if it rests and
/// is not a mesh (the convex hull of a shelf would fill it). The trajectory is certified to avoid
/// the objects that are left out.
bool is_static_obstacle(const SimulatedWorld& world, std::ptrdiff_t object);

/// Returns the model as MJCF, every number with 17 digits. Names: frame k is body and joint "f<k>"
/// (whose value is ratio * q + offset), joint j has the motor "m<j>", capsule k is geom "c<k>",
/// object k "o<k>"; "target" is body and geom; "base" is body, joint and motor of a base that is
/// lifted; "support" is the plane normal to `up` through the target's lowest point, unless the
/// target stands on an object. In that case foot k of the target is the geom "t<k>".
/// Contacts are listed pair by pair, because unlisted pairs would take the larger of two friction
/// values. Listed are:
///   the target with every capsule and every static obstacle, except "table" if a plane replaces
///   it; the target with this plane, or its feet with every static obstacle; the hand's capsules
///   with each other, unless their collision is allowed; the hand's capsules with every static
///   obstacle.
std::string mjcf_text(const SimulatedWorld& world, const Variation& variation,
                      const SimulateOptions& options, Environment environment);

}  // namespace morphe::simulate
