#include "pipeline/planning/plan_movement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/math/seed.hpp"
#include "pipeline/planning/approach.hpp"
#include "pipeline/planning/begin_plan.hpp"
#include "pipeline/planning/contacts.hpp"
#include "pipeline/planning/place_movement.hpp"
#include "pipeline/planning/plan_sentences.hpp"
#include "pipeline/planning/repair_movement.hpp"
#include "pipeline/planning/time_stage.hpp"
#include "stages/certify/approximate_reason.hpp"
#include "stages/certify/certify.hpp"
#include "stages/certify/grasp.hpp"
#include "stages/grasp/measure.hpp"
#include "stages/grasp/quality.hpp"
#include "stages/map/map_movement.hpp"
#include "stages/reconstruct/human_limits.hpp"
#include "stages/scene/move_target.hpp"

namespace morphe::planning {
namespace {

/// The state from which planning a movement starts, for any goals: motion, scene and base position.
struct PreparedMovement {
  Plan begun;
  PlanningFailure failure;  ///< set if the movement cannot be planned
  HumanMotion motion;
  Scene around;
  Vec3 offset = Vec3::Zero();
  std::uint64_t seed = 0;
};

PreparedMovement set_up(const PlanningInputs& planner, const Demonstration& demonstration,
                        const HumanMotion& recorded, const Movement& movement,
                        StageSeconds& seconds, const std::optional<Vec3>& known_offset) {
  const PipelineConfig& config = planner.config;
  PreparedMovement setting;
  setting.begun = begin_plan(demonstration, movement, config.check.tolerances);
  setting.seed =
      math::seed_from(config.seed, fmt::format("{}/{}", demonstration.name, movement.index));
  if (!map::is_hand_only(planner.robot) && !is_known(map::shoulder_at_begin(recorded, movement))) {
    setting.failure = {Reason::no_shoulder, "the shoulder was never seen"};
    return setting;
  }
  setting.failure = reconstruct::check_human_limits(recorded, config.human);
  if (setting.failure) return setting;
  Movement& placed = setting.begun.movement;
  scene::RelocatedMovement there = time_stage(seconds, "scene", [&] {
    const Scene as_recorded = scene_around(planner, demonstration, recorded, placed);
    return scene::move_target(config.scene, recorded, placed, as_recorded);
  });
  setting.motion = std::move(there.motion);
  setting.around = std::move(there.scene);
  setting.offset = known_offset.value_or(Vec3::Zero());
  if (config.map.base_offset.limit_m > 0 && !known_offset) {
    setting.offset = time_stage(seconds, "map", [&] {
      return choose_offset(planner, setting.motion, placed, setting.around,
                           math::seed_from(setting.seed, "offset"));
    });
  }
  return setting;
}

/// Returns true if any fingertip goal was seen during grasp or hold, or there is no such phase.
bool has_grasp_goal(const Goals& goals, const Movement& movement) {
  bool asked = false;
  for (std::size_t f = 0; f < goals.frames(); ++f) {
    if (!is_grasping_at(movement, goals.time[f])) continue;
    asked = true;
    for (std::size_t tip = 0; tip < goals.tip_position.cols; ++tip) {
      if (is_known(goals.tip_position(f, tip))) return true;
    }
  }
  return !asked;
}

/// Computes the time parametrisation and the certificate. If smoothing makes the path collide or
/// moves tips too far from their goals, it is disabled before the plan fails.
void retime_and_certify(const PlanningInputs& planner, const collision::CollisionWorld& world,
                        Plan& plan, StageSeconds& seconds) {
  retime::RetimeOptions options = planner.config.retime;
  while (true) {
    Outcome<retime::RetimeResult> retimed = time_stage(seconds, "retime", [&] {
      return retime::retime(planner.robot, plan.path, plan.movement, options);
    });
    Outcome<Certificate> certified{{}, retimed.failure};
    if (!retimed.failure) {
      plan.trajectory = std::move(retimed.value.trajectory);
      certified = time_stage(seconds, "certify", [&] {
        return certify::certify(world, plan.goals, plan.movement, plan.trajectory, plan.mapped);
      });
    }
    certified.value.repaired = plan.certificate.repaired;
    certified.value.natural_posture_error = plan.certificate.natural_posture_error;
    plan.certificate = certified.value;
    const Reason reason = certified.failure.reason;
    const bool smoothed = options.tip_tolerance + options.joint_tolerance > 0;
    if (smoothed && (reason == Reason::smoothing_collision || reason == Reason::tracking)) {
      options.tip_tolerance = options.joint_tolerance = 0;
      continue;
    }
    plan.reason = reason;
    plan.detail = certified.failure.detail;
    if (reason != Reason::none) plan.trajectory = {};
    return;
  }
}

/// Adds the grasp of an executable plan, its approach and its warnings.
void add_grasp_and_approach(const PlanningInputs& planner, const PreparedMovement& setting,
                            const Contacts& contacts, const collision::CollisionWorld& world,
                            Plan& plan, StageSeconds& seconds) {
  const PipelineConfig& config = planner.config;
  const std::string only_near =
      certify::approximate_reason(plan.goals, plan.tolerances, plan.certificate);
  plan.approximate = !only_near.empty();
  if (config.approach) {
    const PlanningFailure refused = time_stage(seconds, "approach", [&] {
      return add_approach(planner, *config.approach, setting.seed, plan);
    });
    if (refused) {
      plan = fail(std::move(plan), refused);
      return;
    }
  }
  plan.grasp = certify::find_grasp(planner.robot, plan.scene, plan.movement, plan.trajectory);
  if (plan.grasp.sample >= 0) {
    const double at_s = plan.trajectory.demonstration_time[plan.grasp.sample];
    plan.grasp.contacts =
        grasp::measure_contacts(world, contacts.contacts, plan.grasp.grasp_posture, at_s);
    if (config.grasp) {
      const Vec3 down = -plan.reference_frames.base_from_world.linear().col(2);
      grasp::evaluate_grasp(world, at_s, down, *config.grasp, plan.grasp);
    }
  }
  plan.detail = only_near;
  for (const std::string& sentence :
       {warnings(world, plan.goals, plan.movement, setting.motion, plan.trajectory,
                 config.retime.mode == retime::RetimeMode::catch_up),
        join_sentences(contacts.notes), grasp_force_warning(plan.grasp),
        humanlikeness_warning(plan.certificate, plan.goals),
        unchecked_sentence(planner.robot.unchecked_links)}) {
    if (!sentence.empty()) plan.detail += (plan.detail.empty() ? "" : "; ") + sentence;
  }
}

/// Returns true if contacts may free a path: it is free, or only the target obstructs it.
bool can_use_contacts(const Plan& plan) {
  return std::ranges::all_of(plan.remaining_findings, [&](const Finding& finding) {
    return finding.other_body == plan.movement.target;
  });
}

/// Returns the plan with contacts according to the section `grasp`; if contacts are given up, the
/// plan that follows the tips, with the tips kept out of the target as far.
Plan plan_with_contacts(const PlanningInputs& planner, const PreparedMovement& setting,
                        const collision::CollisionWorld& world, const Plan& by_tips,
                        const PlanningFailure& refused_by_tips, StageSeconds& seconds) {
  Contacts contacts =
      time_stage(seconds, "grasp", [&] { return desired_contacts(planner, world, by_tips); });
  while (true) {
    const bool any = !contacts.contacts.empty();
    Plan plan = by_tips;
    if (!any && refused_by_tips) return fail(std::move(plan), refused_by_tips);
    plan.tolerances = world.tolerances;
    const PlanningFailure refused = time_stage(seconds, "grasp", [&] {
      return plan_contacts(planner, world, setting.seed, contacts, plan);
    });
    if (!refused) {
      retime_and_certify(planner, world, plan, seconds);
      if (plan.has_trajectory())
        add_grasp_and_approach(planner, setting, contacts, world, plan, seconds);
      if (plan.has_trajectory() || !any) return plan;
      contacts = {{}, {given_up_sentence({}, {plan.reason, plan.detail})}};
    } else if (!any) {
      return fail(std::move(plan), refused);
    }
  }
}

}  // namespace

Plan plan_movement(const PlanningInputs& planner, const Demonstration& demonstration,
                   const HumanMotion& recorded, const Movement& movement, StageSeconds& seconds,
                   const std::optional<Vec3>& known_offset) {
  const PipelineConfig& config = planner.config;
  const PreparedMovement setting =
      set_up(planner, demonstration, recorded, movement, seconds, known_offset);
  Plan plan = setting.begun;
  if (setting.failure) return fail(std::move(plan), setting.failure);
  PlacedMovement placed(planner, setting.motion, plan.movement, setting.around, setting.offset);
  plan.scene = placed.scene;
  plan.reference_frames = placed.frames;
  plan.goals = placed.goals;
  if (!placed.missing_support.empty())
    return fail(std::move(plan), {Reason::no_reference_frame, placed.missing_support});
  if (!has_grasp_goal(plan.goals, plan.movement)) {
    return fail(std::move(plan), {Reason::no_goal, "no fingertip was seen in the grasp"});
  }
  collision::CollisionWorld world = collision::make_world(planner.robot, plan.scene, plan.movement,
                                                          plan.tolerances, config.scene.meshes);
  Outcome<map::MapResult> mapping = time_stage(seconds, "map", [&] {
    return map::map_movement(placed.problem, plan.goals, config.map, setting.seed);
  });
  if (mapping.failure) return fail(std::move(plan), mapping.failure);
  map::MapResult& mapped = mapping.value;
  plan.mapped = std::move(mapped.mapped);
  plan.path = mapped.path;
  plan.certificate.natural_posture_error = mapped.posture_error_rad;

  plan.findings = time_stage(seconds, "check", [&] {
    return check::check_path(world, plan.goals, plan.movement, plan.path, config.check);
  });
  PlanningFailure failure;
  if (!plan.findings.empty()) {
    Outcome<repair::RepairResult> repaired = time_stage(seconds, "repair", [&] {
      return repair_movement(planner, placed, world, plan, mapped, setting.seed);
    });
    plan.path = std::move(repaired.value.path);
    plan.repair = std::move(repaired.value.attempts);
    plan.remaining_findings = std::move(repaired.value.remaining);
    plan.certificate.repaired = repaired.value.repaired;
    failure = std::move(repaired.failure);
  }
  if (config.grasp && can_use_contacts(plan)) {
    world.tolerances = tolerances_of(config);
    return plan_with_contacts(planner, setting, world, plan, failure, seconds);
  }
  if (failure) return fail(std::move(plan), failure);
  retime_and_certify(planner, world, plan, seconds);
  if (plan.has_trajectory()) add_grasp_and_approach(planner, setting, {}, world, plan, seconds);
  return plan;
}

}  // namespace morphe::planning
