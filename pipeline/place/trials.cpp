#include "pipeline/place/trials.hpp"

#include <algorithm>

#include "core/motion/input_error.hpp"
#include "core/parallel/for_each.hpp"
#include "pipeline/planning/place_movement.hpp"
#include "stages/map/placement.hpp"
#include "stages/scene/move_target.hpp"

namespace morphe::place {
namespace {

constexpr std::size_t kGoalFrames = 12;

}  // namespace

std::optional<Trial> make_trial(const planning::Planner& planner,
                                const std::shared_ptr<const planning::Rebuilt>& rebuilt,
                                std::size_t index) {
  Trial trial;
  trial.rebuilt = rebuilt;
  trial.index = index;
  trial.movement = rebuilt->movements[index];
  if (!seen(map::shoulder_at_begin(rebuilt->motion, trial.movement))) return std::nullopt;
  const Scene as_recorded =
      planning::scene_around(planner, rebuilt->beside, rebuilt->motion, trial.movement);
  scene::MovedTarget there =
      scene::move_target(planner.config.scene, rebuilt->motion, trial.movement, as_recorded);
  trial.motion = std::move(there.motion);
  trial.around = std::move(there.scene);
  trial.shoulder = map::shoulder_at_begin(trial.motion, trial.movement);
  const Goals goals =
      map::make_goals(planner.robot, trial.motion, trial.movement, Pose::Identity());
  if (goals.frames() < 5) return std::nullopt;
  for (const std::size_t frame : planning::few_frames(goals.frames(), kGoalFrames)) {
    for (std::size_t tip = 0; tip < planner.robot.tips.size(); ++tip) {
      trial.goals.push_back(goals.tip_position(frame, tip));
    }
  }
  if (std::ranges::none_of(trial.goals, [](const Vec3& goal) { return seen(goal); })) return {};
  return trial;
}

std::vector<Trial> make_trials(const planning::Planner& planner,
                               const std::vector<Demonstration>& demonstrations,
                               const PlaceOptions& options) {
  if (map::hand_alone(planner.robot)) {
    throw InputError(planner.robot.name + ": is a hand alone: there is no base to place");
  }
  std::vector<Trial> all;
  const auto rebuild = [&](std::uint64_t k) {
    planning::StageSeconds ignored;
    const auto rebuilt = std::make_shared<const planning::Rebuilt>(
        planning::rebuild(planner, demonstrations[k], ignored));
    std::vector<Trial> trials;
    for (std::size_t index = 0; index < rebuilt->movements.size(); ++index) {
      std::optional<Trial> trial = make_trial(planner, rebuilt, index);
      if (trial) trials.push_back(std::move(*trial));
    }
    return trials;
  };
  const auto keep = [&](const std::vector<Trial>& trials) {
    all.insert(all.end(), trials.begin(), trials.end());
  };
  parallel::for_each<std::vector<Trial>>(static_cast<int>(demonstrations.size()), options.jobs,
                                         rebuild, keep);
  if (all.empty()) throw InputError("place: no movement with a shoulder and fingertips");
  std::vector<Trial> few;
  for (const std::size_t k :
       planning::few_frames(all.size(), static_cast<std::size_t>(options.trials))) {
    few.push_back(all[k]);
  }
  return few;
}

}  // namespace morphe::place
