#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "pipeline/place/place_options.hpp"
#include "pipeline/planning/plan_movement.hpp"

namespace morphe::place {

/// A movement on which poses of the base are evaluated, independent of these poses.
struct TrialMovement {
  std::shared_ptr<const planning::Reconstruction> reconstruction;  ///< the whole demonstration
  int index = 0;       ///< of the movement in the reconstruction
  HumanMotion motion;  ///< as planned: adapted to a moved target
  Movement movement;
  Scene surroundings;       ///< in the world frame
  Vec3 shoulder;            ///< human shoulder at the beginning of the movement [m]
  std::vector<Vec3> goals;  ///< [frames * tips] of some frames, in the world, NaN if unknown
  /// Returns the table, or null.
  const SceneObject* table() const { return find_object(surroundings.objects, "table"); }
};

/// Makes a trial; nullopt without a shoulder, without tip goals or with fewer than kMinTrialFrames.
std::optional<TrialMovement> make_trial(
    const planning::PlanningInputs& planner,
    const std::shared_ptr<const planning::Reconstruction>& reconstruction, int index);

/// Returns at most `options.movements` trials, evenly spread over the dataset. Throws InputError if
/// there is no trial, and for a hand without an arm.
std::vector<TrialMovement> make_trials(const planning::PlanningInputs& planner,
                                       const std::vector<Demonstration>& demonstrations,
                                       const PlaceOptions& options);

}  // namespace morphe::place
