#pragma once

#include "core/collision/world.hpp"
#include "pipeline/planning/planner.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::planning {

/// Returns the scene around a movement, in the frame of the motion, and sets movement.target. For a
/// hand alone the scene contains only the objects of the config: table, target and recorded objects
/// are in the world frame, in which such a hand has no pose.
Scene scene_around(const PlanningInputs& planner, const Demonstration& demonstration,
                   const HumanMotion& motion, Movement& movement);

/// Returns the person's other arm, on the robot's side, as obstacles if `scene.other_arm` is set.
/// They are to be added to the demonstration's objects once its movements have been found. Remarks
/// are appended to `notes`. A recorded object of the same name takes precedence.
std::vector<SceneObject> other_arm_obstacles(const PlanningInputs& planner,
                                             const Demonstration& demonstration,
                                             std::vector<std::string>& notes);

/// A movement with the placed robot, ready to be mapped. All members are in the base frame.
struct PlacedMovement {
  /// Places the robot. `around` is in the world frame. `offset` moves the base from its placement,
  /// along the world's axes [m], as if it were added to `placement.shoulder_offset`.
  PlacedMovement(const PlanningInputs& planner, const HumanMotion& motion, const Movement& movement,
                 const Scene& around, const Vec3& offset);
  PlacedMovement(const PlacedMovement&) = delete;
  PlacedMovement& operator=(const PlacedMovement&) = delete;

  Scene scene;
  WorldFrames frames;
  std::string missing_support;  ///< a sentence if the support of an object is missing, otherwise ""
  Goals goals;
  Scene mapping_scene;              ///< part of the scene for the mapping's clearance term
  collision::CollisionWorld world;  ///< of `mapping_scene`
  map::MappingProblem problem;
};

/// Returns at most `most` of a movement's frames, evenly spaced, including the first and the last.
std::vector<std::size_t> evenly_spaced_frames(std::size_t frames, std::size_t most);

/// Section 3.3: returns the offset |o_k| <= base_offset.limit that minimises
///   mean over at most 16 frames of min_q F + base_offset.weight * ‖o‖²,
/// by a compass search from zero with steps down to 1 mm. The minima are those near the best
/// solution without an offset. There is one offset for the whole movement, because the base does
/// not move during it.
Vec3 choose_offset(const PlanningInputs& planner, const HumanMotion& motion,
                   const Movement& movement, const Scene& around, std::uint64_t seed);

}  // namespace morphe::planning
