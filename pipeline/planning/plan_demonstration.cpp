// reconstruct_demonstration() and plan_demonstration() of plan_movement.hpp.
#include <algorithm>
#include <iterator>
#include <utility>

#include "core/parallel/ordered_parallel_map.hpp"
#include "core/robot/hand_dimensions.hpp"
#include "pipeline/planning/begin_plan.hpp"
#include "pipeline/planning/partial_delivery.hpp"
#include "pipeline/planning/place_movement.hpp"
#include "pipeline/planning/plan_movement.hpp"
#include "pipeline/planning/plan_parts.hpp"
#include "pipeline/planning/plan_sentences.hpp"
#include "pipeline/planning/verified_plan.hpp"
#include "stages/reconstruct/hand_frame.hpp"
#include "stages/reconstruct/human_limits.hpp"
#include "stages/reconstruct/mirror.hpp"

namespace morphe::planning {

Reconstruction reconstruct_demonstration(const PlanningInputs& planner,
                                         const Demonstration& demonstration) {
  const PipelineConfig& config = planner.config;
  const bool no_arm = map::is_hand_only(planner.robot);
  Reconstruction result;
  result.motion = planner.timed("reconstruct", [&] {
    return no_arm ? reconstruct::reconstruct_hand(demonstration, config.reconstruct, config.human)
                  : reconstruct::reconstruct(demonstration, config.reconstruct, config.human);
  });
  result.on_robot_side = demonstration;
  result.on_robot_side.objects = reconstruct::objects_on_side(demonstration, Side::right);
  result.movements = planner.timed("segment", [&] {
    return segment::segment(result.motion, config.segment, result.on_robot_side.objects,
                            demonstration.task);
  });
  if (planner.robot.side == Side::left) {
    result.motion = reconstruct::mirror_image(std::move(result.motion));
    result.on_robot_side.objects = reconstruct::objects_on_side(demonstration, Side::left);
  }
  const std::vector<SceneObject> other_arm = planner.timed("reconstruct", [&] {
    return other_arm_obstacles(planner, demonstration, result.motion.reconstruction_notes);
  });
  std::ranges::copy(other_arm, std::back_inserter(result.on_robot_side.objects));
  if (!no_arm) return result;
  result.motion = reconstruct::transform_to_hand_frame(std::move(result.motion));
  const map::HandAlignment fit =
      map::align_hand(robot::hand_dimensions(planner.robot), result.motion.bones, config.hand);
  result.motion = map::apply_alignment(std::move(result.motion), fit);
  if (!fit.problem.empty()) result.motion.reconstruction_notes.push_back(fit.problem);
  return result;
}

run::DemonstrationOutcome plan_demonstration(const PlanningInputs& planning_inputs,
                                             const Demonstration& demonstration) {
  run::DemonstrationOutcome outcome;
  parallel::StageClock clock;
  PlanningInputs planner = planning_inputs;
  planner.clock = &clock;
  const PipelineConfig& config = planner.config;
  const Reconstruction reconstruction = reconstruct_demonstration(planner, demonstration);
  const HumanMotion& motion = reconstruction.motion;
  const std::vector<Movement>& movements = reconstruction.movements;
  const Demonstration& on_robot_side = reconstruction.on_robot_side;
  std::vector<std::vector<Plan>> plans(movements.size());
  parallel::for_each_index(movements.size(), [&](std::size_t k) {
    if (config.split) {
      plans[k] = plan_parts(planner, on_robot_side, motion, movements[k], *config.split);
    } else {
      plans[k].push_back(plan_movement_or_part(planner, on_robot_side, motion, movements[k]));
    }
    for (Plan& plan : plans[k]) plan = verified(planner, std::move(plan));
  });
  for (std::vector<Plan>& parts : plans) {
    for (Plan& part : parts) {
      part.movement.index = static_cast<int>(outcome.plans.size());
      outcome.plans.push_back(std::move(part));
    }
  }
  outcome.stage_cpu_s = clock.seconds();
  if (movements.empty()) {
    const std::string no_reach = map::is_hand_only(planner.robot)
                                     ? "no complete reach was found (for a recording of gestures, "
                                       "set segment.whole_recording)"
                                     : "no complete reach was found";
    const std::string detail = motion.reconstruction_notes.empty()
                                   ? no_reach
                                   : no_reach + "; " + join_sentences(motion.reconstruction_notes);
    outcome.plans.push_back(fail(begin_plan(demonstration, {}, planner.config.check.tolerances),
                                 {Reason::no_movement, detail}));
  }
  return outcome;
}

}  // namespace morphe::planning
