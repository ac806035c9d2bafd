#include "pipeline/place/trial_movements.hpp"

#include <algorithm>

#include "core/motion/input_error.hpp"
#include "core/parallel/for_each.hpp"
#include "pipeline/planning/place_movement.hpp"
#include "stages/map/placement.hpp"
#include "stages/scene/move_target.hpp"

namespace morphe::place {
namespace {

constexpr std::size_t kGoalFrameCount = 12;

}  // namespace

std::optional<TrialMovement> make_trial(
    const planning::PlanningInputs& planner,
    const std::shared_ptr<const planning::Reconstruction>& rebuilt, std::size_t index) {
  TrialMovement trial;
  trial.reconstruction = rebuilt;
  trial.index = index;
  trial.movement = rebuilt->movements[index];
  if (!is_known(map::shoulder_at_begin(rebuilt->motion, trial.movement))) return std::nullopt;
  const Scene as_recorded =
      planning::scene_around(planner, rebuilt->on_robot_side, rebuilt->motion, trial.movement);
  scene::RelocatedMovement there =
      scene::move_target(planner.config.scene, rebuilt->motion, trial.movement, as_recorded);
  trial.motion = std::move(there.motion);
  trial.surroundings = std::move(there.scene);
  trial.shoulder = map::shoulder_at_begin(trial.motion, trial.movement);
  const Goals goals =
      map::make_goals(planner.robot, trial.motion, trial.movement, Pose::Identity());
  if (goals.frames() < 5) return std::nullopt;
  for (const std::size_t frame : planning::evenly_spaced_frames(goals.frames(), kGoalFrameCount)) {
    for (std::size_t tip = 0; tip < planner.robot.tips.size(); ++tip) {
      trial.goals.push_back(goals.tip_position(frame, tip));
    }
  }
  if (std::ranges::none_of(trial.goals, [](const Vec3& goal) { return is_known(goal); })) return {};
  return trial;
}

std::vector<TrialMovement> make_trials(const planning::PlanningInputs& planner,
                                       const std::vector<Demonstration>& demonstrations,
                                       const PlaceOptions& options) {
  if (map::is_hand_only(planner.robot)) {
    throw InputError(planner.robot.name + ": is a hand without an arm: it has no base to place");
  }
  std::vector<TrialMovement> all;
  const auto rebuild = [&](std::uint64_t k) {
    planning::StageSeconds ignored;
    const auto rebuilt = std::make_shared<const planning::Reconstruction>(
        planning::reconstruct_demonstration(planner, demonstrations[k], ignored));
    std::vector<TrialMovement> trials;
    for (std::size_t index = 0; index < rebuilt->movements.size(); ++index) {
      std::optional<TrialMovement> trial = make_trial(planner, rebuilt, index);
      if (trial) trials.push_back(std::move(*trial));
    }
    return trials;
  };
  const auto keep = [&](const std::vector<TrialMovement>& trials) {
    all.insert(all.end(), trials.begin(), trials.end());
  };
  parallel::ordered_for_each<std::vector<TrialMovement>>(static_cast<int>(demonstrations.size()),
                                                         options.jobs, rebuild, keep);
  if (all.empty())
    throw InputError("place: the dataset has no movement with a shoulder and fingertips");
  std::vector<TrialMovement> few;
  for (const std::size_t k : planning::evenly_spaced_frames(all.size(), options.movements)) {
    few.push_back(all[k]);
  }
  return few;
}

}  // namespace morphe::place
