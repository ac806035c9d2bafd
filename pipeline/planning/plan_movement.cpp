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
#include "pipeline/planning/timed.hpp"
#include "stages/certify/certify.hpp"
#include "stages/certify/grasp.hpp"
#include "stages/certify/only_near.hpp"
#include "stages/grasp/measure.hpp"
#include "stages/grasp/quality.hpp"
#include "stages/map/map_movement.hpp"
#include "stages/reconstruct/human_limits.hpp"
#include "stages/scene/move_target.hpp"

namespace morphe::planning {
namespace {

/// What planning a movement begins with, whatever its goals ask for: everything in its place.
struct Setting {
  Plan begun;
  Refusal refusal;  ///< nothing more can be planned
  HumanMotion motion;
  Scene around;
  Vec3 offset = Vec3::Zero();
  std::uint64_t seed = 0;
};

Setting set_up(const Planner& planner, const Demonstration& demonstration,
               const HumanMotion& recorded, const Movement& movement, StageSeconds& seconds,
               const std::optional<Vec3>& known_offset) {
  const PipelineConfig& config = planner.config;
  Setting setting;
  setting.begun = begin_plan(demonstration, movement, config.check.tolerances);
  setting.seed =
      math::seed_from(config.seed, fmt::format("{}/{}", demonstration.name, movement.index));
  if (!map::hand_alone(planner.robot) && !seen(map::shoulder_at_begin(recorded, movement))) {
    setting.refusal = {Reason::no_shoulder, "the shoulder was never seen"};
    return setting;
  }
  setting.refusal = reconstruct::refuse_inhuman(recorded, config.human);
  if (setting.refusal) return setting;
  Movement& placed = setting.begun.movement;
  scene::MovedTarget there = timed(seconds, "scene", [&] {
    const Scene as_recorded = scene_around(planner, demonstration, recorded, placed);
    return scene::move_target(config.scene, recorded, placed, as_recorded);
  });
  setting.motion = std::move(there.motion);
  setting.around = std::move(there.scene);
  setting.offset = known_offset.value_or(Vec3::Zero());
  if (config.map.free_offset.limit_m > 0 && !known_offset) {
    setting.offset = timed(seconds, "map", [&] {
      return choose_offset(planner, setting.motion, placed, setting.around,
                           math::seed_from(setting.seed, "offset"));
    });
  }
  return setting;
}

/// Whether any fingertip goal was seen while the hand grasps (or holds); true without such a phase.
bool grasp_seen(const Goals& goals, const Movement& movement) {
  bool asked = false;
  for (std::size_t f = 0; f < goals.frames(); ++f) {
    if (!grasping_at(movement, goals.time[f])) continue;
    asked = true;
    for (std::size_t tip = 0; tip < goals.tip_position.cols; ++tip) {
      if (seen(goals.tip_position(f, tip))) return true;
    }
  }
  return !asked;
}

/// Time law and certificate. Smoothing that makes a path collide, or takes tips too far from their
/// goals, is taken back before giving up.
void finish(const Planner& planner, const collision::CollisionWorld& world, Plan& plan,
            StageSeconds& seconds) {
  retime::RetimeOptions options = planner.config.retime;
  while (true) {
    Outcome<retime::RetimeResult> retimed = timed(seconds, "retime", [&] {
      return retime::retime(planner.robot, plan.path, plan.movement, options);
    });
    Outcome<Certificate> certified{{}, retimed.refusal};
    if (!retimed.refusal) {
      plan.trajectory = std::move(retimed.value.trajectory);
      certified = timed(seconds, "certify", [&] {
        return certify::certify(world, plan.goals, plan.movement, plan.trajectory, plan.mapped);
      });
    }
    certified.value.repaired = plan.certificate.repaired;
    certified.value.natural_posture_error = plan.certificate.natural_posture_error;
    plan.certificate = certified.value;
    const Reason reason = certified.refusal.reason;
    const bool smoothed = options.tip_tolerance + options.joint_tolerance > 0;
    if (smoothed && (reason == Reason::smoothing || reason == Reason::tracking)) {
      options.tip_tolerance = options.joint_tolerance = 0;
      continue;
    }
    plan.reason = reason;
    plan.detail = certified.refusal.detail;
    if (reason != Reason::none) plan.trajectory = {};
    return;
  }
}

/// The grasp of an executable plan, its approach, and what a user must know of it.
void complete(const Planner& planner, const Setting& setting, const Contacts& contacts,
              const collision::CollisionWorld& world, Plan& plan, StageSeconds& seconds) {
  const PipelineConfig& config = planner.config;
  const std::string only_near = certify::only_near(plan.goals, plan.tolerances, plan.certificate);
  plan.approximate = !only_near.empty();
  if (config.approach) {
    const Refusal refused = timed(seconds, "approach", [&] {
      return add_approach(planner, *config.approach, setting.seed, plan);
    });
    if (refused) {
      plan = fail(std::move(plan), refused);
      return;
    }
  }
  plan.grasp = certify::find_grasp(planner.robot, plan.scene, plan.movement, plan.trajectory);
  if (plan.grasp.sample >= 0) {
    const double at_s =
        plan.trajectory.demonstration_time[static_cast<std::size_t>(plan.grasp.sample)];
    plan.grasp.contacts =
        grasp::measure_contacts(world, contacts.touches, plan.grasp.hand_posture, at_s);
    if (config.grasp) {
      const Vec3 down = -plan.world.base_from_world.linear().col(2);
      grasp::judge_grasp(world, at_s, down, *config.grasp, plan.grasp);
    }
  }
  plan.detail = only_near;
  for (const std::string& sentence :
       {warnings(world, plan.goals, plan.movement, setting.motion, plan.trajectory,
                 config.retime.mode == retime::Tempo::kept),
        joined(contacts.notes), no_squeeze(plan.grasp), not_humanlike(plan.certificate, plan.goals),
        unchecked_sentence(planner.robot.unchecked_links)}) {
    if (!sentence.empty()) plan.detail += (plan.detail.empty() ? "" : "; ") + sentence;
  }
}

/// Whether contacts may be what a path needs: it is free, or nothing but the target is in its way.
bool may_touch(const Plan& plan) {
  return std::ranges::all_of(plan.remaining, [&](const Finding& finding) {
    return finding.second == plan.movement.target;
  });
}

/// The plan with its hand on the target, as the section `grasp` asks for it; where contacts are
/// given up, the one by tips, as far out of the target.
Plan plan_on_target(const Planner& planner, const Setting& setting,
                    const collision::CollisionWorld& world, const Plan& by_tips,
                    const Refusal& refused_by_tips, StageSeconds& seconds) {
  Contacts contacts =
      timed(seconds, "grasp", [&] { return wanted_contacts(planner, world, by_tips); });
  while (true) {
    const bool any = !contacts.touches.empty();
    Plan plan = by_tips;
    if (!any && refused_by_tips) return fail(std::move(plan), refused_by_tips);
    plan.tolerances = world.tolerances;
    const Refusal refused = timed(seconds, "grasp", [&] {
      return touch_target(planner, world, setting.seed, contacts, plan);
    });
    if (!refused) {
      finish(planner, world, plan, seconds);
      if (plan.has_trajectory()) complete(planner, setting, contacts, world, plan, seconds);
      if (plan.has_trajectory() || !any) return plan;
      contacts = {{}, {given_up_sentence({}, {plan.reason, plan.detail})}};
    } else if (!any) {
      return fail(std::move(plan), refused);
    }
  }
}

}  // namespace

Plan plan_movement(const Planner& planner, const Demonstration& demonstration,
                   const HumanMotion& recorded, const Movement& movement, StageSeconds& seconds,
                   const std::optional<Vec3>& known_offset) {
  const PipelineConfig& config = planner.config;
  const Setting setting = set_up(planner, demonstration, recorded, movement, seconds, known_offset);
  Plan plan = setting.begun;
  if (setting.refusal) return fail(std::move(plan), setting.refusal);
  PlacedMovement placed(planner, setting.motion, plan.movement, setting.around, setting.offset);
  plan.scene = placed.scene;
  plan.world = placed.frames;
  plan.goals = placed.goals;
  if (!placed.nowhere.empty()) return fail(std::move(plan), {Reason::no_frame, placed.nowhere});
  if (!grasp_seen(plan.goals, plan.movement)) {
    return fail(std::move(plan), {Reason::no_goal, "no fingertip was seen in the grasp"});
  }
  collision::CollisionWorld world = collision::make_world(planner.robot, plan.scene, plan.movement,
                                                          plan.tolerances, config.scene.meshes);
  Outcome<map::MapResult> mapping = timed(seconds, "map", [&] {
    return map::map_movement(placed.problem, plan.goals, config.map, setting.seed);
  });
  if (mapping.refusal) return fail(std::move(plan), mapping.refusal);
  map::MapResult& mapped = mapping.value;
  plan.mapped = std::move(mapped.mapped);
  plan.path = mapped.path;
  plan.certificate.natural_posture_error = mapped.posture_error_rad;

  plan.findings = timed(seconds, "check", [&] {
    return check::check_path(world, plan.goals, plan.movement, plan.path, config.check);
  });
  Refusal refusal;
  if (!plan.findings.empty()) {
    Outcome<repair::RepairResult> repaired = timed(seconds, "repair", [&] {
      return repair_movement(planner, placed, world, plan, mapped, setting.seed);
    });
    plan.path = std::move(repaired.value.path);
    plan.repair = std::move(repaired.value.steps);
    plan.remaining = std::move(repaired.value.remaining);
    plan.certificate.repaired = repaired.value.repaired;
    refusal = std::move(repaired.refusal);
  }
  if (config.grasp && may_touch(plan)) {
    world.tolerances = tolerances_of(config);
    return plan_on_target(planner, setting, world, plan, refusal, seconds);
  }
  if (refusal) return fail(std::move(plan), refusal);
  finish(planner, world, plan, seconds);
  if (plan.has_trajectory()) complete(planner, setting, {}, world, plan, seconds);
  return plan;
}

}  // namespace morphe::planning
