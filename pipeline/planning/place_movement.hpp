#pragma once

#include "core/collision/world.hpp"
#include "pipeline/planning/planner.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::planning {

/// The bodies around a movement, in the frame of the motion; sets movement.target. Around a hand
/// alone there is only what the config names: table, target and recorded objects are the world's,
/// in which such a hand has no place.
Scene scene_around(const Planner& planner, const Demonstration& demonstration,
                   const HumanMotion& motion, Movement& movement);

/// The person's other arm where the robot's side has it, if `scene.other_arm` asks for it:
/// obstacles to stand among the demonstration's objects, once its movements are found. What became
/// of it is said in `notes`. A recorded object of such a name stays what it is.
std::vector<SceneObject> other_arm_beside(const Planner& planner,
                                          const Demonstration& demonstration,
                                          std::vector<std::string>& notes);

/// A movement with the robot in its place, ready to be mapped. All but `around` in the base frame.
struct PlacedMovement {
  /// `offset` moves the base from where the placement puts it, along the world's axes [m]: as if
  /// it were added to `placement.shoulder_offset`.
  PlacedMovement(const Planner& planner, const HumanMotion& motion, const Movement& movement,
                 const Scene& around, const Vec3& offset);
  PlacedMovement(const PlacedMovement&) = delete;
  PlacedMovement& operator=(const PlacedMovement&) = delete;

  Scene scene;
  WorldFrames frames;
  std::string nowhere;  ///< a sentence: what an object stands on is not there; "" if all is
  Goals goals;
  Scene known;                      ///< the part of the scene that the mapping keeps clear of
  collision::CollisionWorld world;  ///< of `known`
  map::MappingProblem problem;
};

/// At most so many of a movement's frames, evenly spread, the first and the last among them.
std::vector<std::size_t> few_frames(std::size_t frames, std::size_t most);

/// Section 3.3: the offset |o_k| <= free_offset.limit that makes
///   mean over at most 16 frames of min_q F + free_offset.weight * ‖o‖²
/// least, found by a compass search from zero in steps down to 1 mm. Minima are those near the best
/// course without an offset. One offset for the whole movement: a base does not move while the arm
/// does.
Vec3 choose_offset(const Planner& planner, const HumanMotion& motion, const Movement& movement,
                   const Scene& around, std::uint64_t seed);

}  // namespace morphe::planning
