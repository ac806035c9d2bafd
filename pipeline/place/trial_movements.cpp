#include "pipeline/place/trial_movements.hpp"

#include <algorithm>

#include "core/motion/input_error.hpp"
#include "core/parallel/for_each.hpp"
#include "pipeline/place/constants.hpp"
#include "pipeline/planning/place_movement.hpp"
#include "stages/map/placement.hpp"
#include "stages/scene/move_target.hpp"

namespace morphe::place {

std::optional<TrialMovement> make_trial(
    const planning::PlanningInputs& planner,
    const std::shared_ptr<const planning::Reconstruction>& reconstruction, int index) {
  TrialMovement trial;
  trial.reconstruction = reconstruction;
  trial.index = index;
  trial.movement = reconstruction->movements[index];
  if (!is_known(map::shoulder_at_begin(reconstruction->motion, trial.movement)))
    return std::nullopt;
  const Scene as_recorded = planning::scene_around(planner, reconstruction->on_robot_side,
                                                   reconstruction->motion, trial.movement);
  scene::RelocatedMovement relocated =
      scene::move_target(planner.config.scene, reconstruction->motion, trial.movement, as_recorded);
  trial.motion = std::move(relocated.motion);
  trial.surroundings = std::move(relocated.scene);
  trial.shoulder = map::shoulder_at_begin(trial.motion, trial.movement);
  const Goals goals =
      map::make_goals(planner.robot, trial.motion, trial.movement, Pose::Identity());
  if (goals.frames() < kMinTrialFrames) return std::nullopt;
  for (const std::size_t frame : planning::evenly_spaced_indices(goals.frames(), kGoalFrameCount))
    for (int tip = 0; tip < std::ssize(planner.robot.tips); ++tip)
      trial.goals.push_back(goals.tip_position(frame, tip));
  if (std::ranges::none_of(trial.goals, [](const Vec3& goal) { return is_known(goal); })) return {};
  return trial;
}

std::vector<TrialMovement> make_trials(const planning::PlanningInputs& planner,
                                       const std::vector<Demonstration>& demonstrations,
                                       const PlaceOptions& options) {
  if (map::is_hand_only(planner.robot))
    throw InputError(planner.robot.name + ": is a hand without an arm: it has no base to place");
  std::vector<TrialMovement> all;
  const auto reconstruct = [&](std::uint64_t k) {
    const auto reconstruction = std::make_shared<const planning::Reconstruction>(
        planning::reconstruct_demonstration(planner, demonstrations[k]));
    std::vector<TrialMovement> trials;
    for (int index = 0; index < std::ssize(reconstruction->movements); ++index)
      if (std::optional<TrialMovement> trial = make_trial(planner, reconstruction, index))
        trials.push_back(std::move(*trial));
    return trials;
  };
  const auto keep = [&](const std::vector<TrialMovement>& trials) {
    all.insert(all.end(), trials.begin(), trials.end());
  };
  parallel::ordered_for_each<std::vector<TrialMovement>>(static_cast<int>(demonstrations.size()),
                                                         options.jobs, reconstruct, keep);
  if (all.empty())
    throw InputError("place: the dataset has no movement with a shoulder and fingertips");
  std::vector<TrialMovement> few;
  for (const std::size_t k : planning::evenly_spaced_indices(all.size(), options.movements))
    few.push_back(all[k]);
  return few;
}

}  // namespace morphe::place
