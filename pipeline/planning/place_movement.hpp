#pragma once

#include "core/collision/world.hpp"
#include "pipeline/planning/planner.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::planning {

/// Returns the scene around a movement, in the frame of the motion, and sets movement.target. For a
/// hand without an arm the scene contains only the config's objects, and movement.target becomes
/// "": table, target and recorded objects are in the world frame, in which such a hand has no pose.
Scene scene_around(const PlanningInputs& planner, const Demonstration& demonstration,
                   const HumanMotion& motion, Movement& movement);

/// Returns the capsules of the person's other arm if `scene.other_arm` is set, mirrored like the
/// demonstration's objects, to which the caller adds them after its movements have been found.
/// Capsules with the name of a recorded object are left out. Remarks are appended to `notes`.
std::vector<SceneObject> other_arm_obstacles(const PlanningInputs& planner,
                                             const Demonstration& demonstration,
                                             std::vector<std::string>& notes);

/// A movement with the placed robot, ready to be mapped. All members are in the base frame.
struct PlacedMovement {
  /// Places the robot. `around` is the scene in the world frame. `offset` [m, along the world's
  /// axes] is added to the config's `placement.shoulder_offset`.
  PlacedMovement(const PlanningInputs& planner, const HumanMotion& motion, const Movement& movement,
                 const Scene& around, const Vec3& offset);
  PlacedMovement(const PlacedMovement&) = delete;
  PlacedMovement& operator=(const PlacedMovement&) = delete;

  Scene scene;
  WorldFrames frames;
  std::string missing_support;  ///< a sentence if an object's reference frame is missing, else ""
  Goals goals;
  Scene mapping_scene;              ///< the objects that the mapping's clearance term avoids
  collision::CollisionWorld world;  ///< of `mapping_scene`
  map::MappingProblem problem;
};

/// Returns min(count, max_count) evenly spaced indices of a list of `count` elements: the first,
/// the last and those between, or only the first. `max_count` must be positive.
std::vector<std::size_t> evenly_spaced_indices(std::size_t count, std::size_t max_count);

/// Section 3.3: returns the offset o with |o_k| <= base_offset.limit that minimises
///   (mean over at most 16 frames of min_q F) + base_offset.weight * ‖o‖²
/// by a compass search from zero with steps down to 1 mm. min_q F is the minimum to which a descent
/// from the best path without an offset leads. Returns zero for a movement without fingertip goals
/// or with fewer than five frames. The movement has one offset, because the base does not move.
Vec3 choose_offset(const PlanningInputs& planner, const HumanMotion& motion,
                   const Movement& movement, const Scene& around, std::uint64_t seed);

}  // namespace morphe::planning
