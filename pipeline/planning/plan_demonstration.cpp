// rebuild() and plan_demonstration() of plan_movement.hpp.
#include <algorithm>
#include <iterator>
#include <utility>

#include "core/parallel/ordered_map.hpp"
#include "core/robot/hand_bones.hpp"
#include "pipeline/planning/begin_plan.hpp"
#include "pipeline/planning/place_movement.hpp"
#include "pipeline/planning/plan_movement.hpp"
#include "pipeline/planning/plan_parts.hpp"
#include "pipeline/planning/plan_sentences.hpp"
#include "pipeline/planning/timed.hpp"
#include "stages/reconstruct/hand_frame.hpp"
#include "stages/reconstruct/human_limits.hpp"
#include "stages/reconstruct/mirror.hpp"

namespace morphe::planning {

Rebuilt rebuild(const Planner& planner, const Demonstration& demonstration, StageSeconds& seconds) {
  const PipelineConfig& config = planner.config;
  const bool alone = map::hand_alone(planner.robot);
  Rebuilt rebuilt;
  rebuilt.motion = timed(seconds, "reconstruct", [&] {
    return alone ? reconstruct::reconstruct_hand(demonstration, config.reconstruct, config.human)
                 : reconstruct::reconstruct(demonstration, config.reconstruct, config.human);
  });
  rebuilt.beside = demonstration;
  rebuilt.beside.objects = reconstruct::objects_beside(demonstration, Side::right);
  rebuilt.movements = timed(seconds, "segment", [&] {
    return segment::segment(rebuilt.motion, config.segment, rebuilt.beside.objects);
  });
  if (planner.robot.side == Side::left) {
    rebuilt.motion = reconstruct::mirrored(std::move(rebuilt.motion));
    rebuilt.beside.objects = reconstruct::objects_beside(demonstration, Side::left);
  }
  const std::vector<SceneObject> other_arm = timed(seconds, "reconstruct", [&] {
    return other_arm_beside(planner, demonstration, rebuilt.motion.problems);
  });
  std::ranges::copy(other_arm, std::back_inserter(rebuilt.beside.objects));
  if (!alone) return rebuilt;
  rebuilt.motion = reconstruct::in_hand_frame(std::move(rebuilt.motion));
  const map::HandFit fit =
      map::fit_hand(robot::hand_bones(planner.robot), rebuilt.motion.bones, config.hand);
  rebuilt.motion = map::fitted_motion(std::move(rebuilt.motion), fit);
  if (!fit.problem.empty()) rebuilt.motion.problems.push_back(fit.problem);
  return rebuilt;
}

run::DemonstrationOutcome plan_demonstration(const Planner& planner,
                                             const Demonstration& demonstration) {
  run::DemonstrationOutcome outcome;
  StageSeconds& seconds = outcome.stage_seconds;
  const PipelineConfig& config = planner.config;
  const Rebuilt rebuilt = rebuild(planner, demonstration, seconds);
  const HumanMotion& motion = rebuilt.motion;
  const std::vector<Movement>& movements = rebuilt.movements;
  const Demonstration& beside = rebuilt.beside;
  std::vector<std::vector<Plan>> plans(movements.size());
  std::vector<StageSeconds> of_movement(movements.size());
  parallel::for_each_index(movements.size(), [&](std::size_t k) {
    if (config.parts) {
      plans[k] = plan_parts(planner, beside, motion, movements[k], *config.parts, of_movement[k]);
    } else {
      plans[k].push_back(plan_movement(planner, beside, motion, movements[k], of_movement[k]));
    }
  });
  for (std::vector<Plan>& parts : plans) {
    for (Plan& part : parts) {
      part.movement.index = static_cast<int>(outcome.plans.size());
      outcome.plans.push_back(std::move(part));
    }
  }
  for (const StageSeconds& own : of_movement) {
    for (const auto& [stage, taken] : own) seconds[stage] += taken;
  }
  if (movements.empty()) {
    const std::string nothing =
        map::hand_alone(planner.robot)
            ? "no complete reach in it (segment.whole plans a recording of gestures)"
            : "no complete reach in it";
    const std::string detail =
        motion.problems.empty() ? nothing : nothing + "; " + joined(motion.problems);
    outcome.plans.push_back(fail(begin_plan(demonstration, {}, planner.config.check.tolerances),
                                 {Reason::no_movement, detail}));
  }
  return outcome;
}

}  // namespace morphe::planning
