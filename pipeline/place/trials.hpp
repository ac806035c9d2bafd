#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "pipeline/place/place_options.hpp"
#include "pipeline/planning/plan_movement.hpp"

namespace morphe::place {

/// A movement that placements are tried on: rebuilt and segmented once, with all that is around it.
struct Trial {
  std::shared_ptr<const planning::Rebuilt> rebuilt;  ///< of its demonstration
  std::size_t index = 0;                             ///< of the movement
  HumanMotion motion;                                ///< as it is to be planned
  Movement movement;
  Scene around;             ///< world frame
  Vec3 shoulder;            ///< human's, at the movement's begin [m]
  std::vector<Vec3> goals;  ///< [few * tips] tip goals in the world, NaN: none
  const SceneObject* table() const { return object_named(around.objects, "table"); }
};

/// Nothing where nothing can be tried: no shoulder, no tip goal, fewer than five frames.
std::optional<Trial> make_trial(const planning::Planner& planner,
                                const std::shared_ptr<const planning::Rebuilt>& rebuilt,
                                std::size_t index);

/// The movements of the demonstrations that have a shoulder and tip goals, evenly at most
/// `options.trials` of them. InputError if there is none, or if the robot is a hand alone.
std::vector<Trial> make_trials(const planning::Planner& planner,
                               const std::vector<Demonstration>& demonstrations,
                               const PlaceOptions& options);

}  // namespace morphe::place
