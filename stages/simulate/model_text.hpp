#pragma once

#include <string>
#include <vector>

#include "core/motion/robot_table.hpp"
#include "core/motion/scene.hpp"
#include "stages/simulate/bodies.hpp"
#include "stages/simulate/options.hpp"
#include "stages/simulate/servos.hpp"

namespace morphe::simulate {

/// What differs between the models of one plan.
struct Variation {
  double friction = 0, torsion_m = 0, mass_kg = 0;
  Pose base_from_target = Pose::Identity();
};

/// A robot with its target on what it stands on, seen from the robot's base.
struct SimulatedWorld {
  const RobotTable* robot = nullptr;
  std::vector<Servo> servos;      ///< [joints]
  std::vector<Inertia> inertias;  ///< [frames]
  const Scene* scene = nullptr;
  int target = -1;  ///< of scene->objects
  Vec3 up = Vec3::UnitZ();
  bool lifts_base = false;  ///< a hand without an arm: its base slides along `up`
};

/// Whether the target stands in the world, or hangs in the hand alone, without weight, support and
/// everything that stands around it.
enum class Around { world, nothing };

/// Whether an object is part of the model beside the target: one that moves is not, nor a mesh,
/// whose hull would fill a shelf. The trajectory is certified clear of them.
bool stands_around(const SimulatedWorld& world, std::size_t object);

/// MJCF, every number with 17 digits. Names: frame k is body and joint "f<k>" (whose value is
/// ratio * q + offset), joint j has the motor "m<j>", capsule k is geom "c<k>"; "target" is body
/// and geom; "base" is body, joint and motor of a base that is lifted; object k is geom "o<k>",
/// "support" the plane on which the target stands: through its lowest point, normal to `up`.
/// Contacts are listed pair by pair, since what is not listed would combine friction by the larger
/// of two: the target with every capsule, with the support and with every object that stands around
/// but the one called "table", on which it is taken to stand; capsules of the hand with each other,
/// where they may collide, and with all these objects. A target's mesh counts as its convex hull.
std::string model_text(const SimulatedWorld& world, const Variation& variation,
                       const SimulateOptions& options, Around around);

}  // namespace morphe::simulate
