#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "pipeline/place/place_options.hpp"
#include "pipeline/planning/plan_movement.hpp"

namespace morphe::place {

/// A movement on which placements are evaluated: reconstructed and segmented once, with its
/// surroundings.
struct TrialMovement {
  /// Reconstruction of its demonstration.
  std::shared_ptr<const planning::Reconstruction> reconstruction;
  /// Index of the movement.
  std::size_t index = 0;
  /// Motion as it is to be planned.
  HumanMotion motion;
  /// The movement.
  Movement movement;
  /// The surroundings in the world frame.
  Scene surroundings;
  /// Human shoulder at the beginning of the movement [m].
  Vec3 shoulder;
  /// [few * tips] tip goals in the world frame, NaN if there is no goal.
  std::vector<Vec3> goals;
  /// Returns the table, null if there is no table.
  const SceneObject* table() const { return find_object(surroundings.objects, "table"); }
};

/// Makes a trial from a movement. Returns an empty value if it has no shoulder, no tip goal, or
/// fewer than five frames.
std::optional<TrialMovement> make_trial(
    const planning::PlanningInputs& planner,
    const std::shared_ptr<const planning::Reconstruction>& rebuilt, std::size_t index);

/// Selects at most `options.trials` movements, evenly distributed, from the movements of the
/// demonstrations that have a shoulder and tip goals. Throws InputError if there is no such
/// movement, or if the robot is a hand alone.
std::vector<TrialMovement> make_trials(const planning::PlanningInputs& planner,
                                       const std::vector<Demonstration>& demonstrations,
                                       const PlaceOptions& options);

}  // namespace morphe::place
