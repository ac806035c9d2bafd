// reconstruct_demonstration() and plan_demonstration() of plan_movement.hpp.
#include <algorithm>
#include <iterator>
#include <utility>

#include "core/parallel/ordered_parallel_map.hpp"
#include "core/robot/hand_dimensions.hpp"
#include "pipeline/planning/begin_plan.hpp"
#include "pipeline/planning/place_movement.hpp"
#include "pipeline/planning/plan_movement.hpp"
#include "pipeline/planning/plan_parts.hpp"
#include "pipeline/planning/plan_sentences.hpp"
#include "pipeline/planning/time_stage.hpp"
#include "stages/reconstruct/hand_frame.hpp"
#include "stages/reconstruct/human_limits.hpp"
#include "stages/reconstruct/mirror.hpp"

namespace morphe::planning {

Reconstruction reconstruct_demonstration(const PlanningInputs& planner,
                                         const Demonstration& demonstration,
                                         StageSeconds& seconds) {
  const PipelineConfig& config = planner.config;
  const bool alone = map::is_hand_only(planner.robot);
  Reconstruction rebuilt;
  rebuilt.motion = time_stage(seconds, "reconstruct", [&] {
    return alone ? reconstruct::reconstruct_hand(demonstration, config.reconstruct, config.human)
                 : reconstruct::reconstruct(demonstration, config.reconstruct, config.human);
  });
  rebuilt.on_robot_side = demonstration;
  rebuilt.on_robot_side.objects = reconstruct::objects_on_side(demonstration, Side::right);
  rebuilt.movements = time_stage(seconds, "segment", [&] {
    return segment::segment(rebuilt.motion, config.segment, rebuilt.on_robot_side.objects);
  });
  if (planner.robot.side == Side::left) {
    rebuilt.motion = reconstruct::mirror_image(std::move(rebuilt.motion));
    rebuilt.on_robot_side.objects = reconstruct::objects_on_side(demonstration, Side::left);
  }
  const std::vector<SceneObject> other_arm = time_stage(seconds, "reconstruct", [&] {
    return other_arm_obstacles(planner, demonstration, rebuilt.motion.reconstruction_notes);
  });
  std::ranges::copy(other_arm, std::back_inserter(rebuilt.on_robot_side.objects));
  if (!alone) return rebuilt;
  rebuilt.motion = reconstruct::transform_to_hand_frame(std::move(rebuilt.motion));
  const map::HandAlignment fit =
      map::align_hand(robot::hand_dimensions(planner.robot), rebuilt.motion.bones, config.hand);
  rebuilt.motion = map::apply_alignment(std::move(rebuilt.motion), fit);
  if (!fit.problem.empty()) rebuilt.motion.reconstruction_notes.push_back(fit.problem);
  return rebuilt;
}

run::DemonstrationOutcome plan_demonstration(const PlanningInputs& planner,
                                             const Demonstration& demonstration) {
  run::DemonstrationOutcome outcome;
  StageSeconds& seconds = outcome.stage_cpu_s;
  const PipelineConfig& config = planner.config;
  const Reconstruction rebuilt = reconstruct_demonstration(planner, demonstration, seconds);
  const HumanMotion& motion = rebuilt.motion;
  const std::vector<Movement>& movements = rebuilt.movements;
  const Demonstration& beside = rebuilt.on_robot_side;
  std::vector<std::vector<Plan>> plans(movements.size());
  std::vector<StageSeconds> of_movement(movements.size());
  parallel::for_each_index(movements.size(), [&](std::size_t k) {
    if (config.split) {
      plans[k] = plan_parts(planner, beside, motion, movements[k], *config.split, of_movement[k]);
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
    const std::string nothing = map::is_hand_only(planner.robot)
                                    ? "no complete reach was found (for a recording of gestures, "
                                      "set segment.whole_recording)"
                                    : "no complete reach was found";
    const std::string detail = motion.reconstruction_notes.empty()
                                   ? nothing
                                   : nothing + "; " + join_sentences(motion.reconstruction_notes);
    outcome.plans.push_back(fail(begin_plan(demonstration, {}, planner.config.check.tolerances),
                                 {Reason::no_movement, detail}));
  }
  return outcome;
}

}  // namespace morphe::planning
