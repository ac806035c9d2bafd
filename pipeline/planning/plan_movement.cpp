#include "pipeline/planning/plan_movement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/math/seed.hpp"
#include "pipeline/planning/approach.hpp"
#include "pipeline/planning/assumptions.hpp"
#include "pipeline/planning/begin_plan.hpp"
#include "pipeline/planning/constants.hpp"
#include "pipeline/planning/contacts.hpp"
#include "pipeline/planning/keep_tempo.hpp"
#include "pipeline/planning/place_movement.hpp"
#include "pipeline/planning/plan_branch.hpp"
#include "pipeline/planning/plan_sentences.hpp"
#include "pipeline/planning/repair_movement.hpp"
#include "pipeline/planning/smoothing_fallback.hpp"
#include "stages/certify/approximate_reason.hpp"
#include "stages/certify/certify.hpp"
#include "stages/certify/grasp.hpp"
#include "stages/grasp/carrying.hpp"
#include "stages/grasp/held_drift.hpp"
#include "stages/grasp/measure.hpp"
#include "stages/grasp/quality.hpp"
#include "stages/import/audit/movement_checks.hpp"
#include "stages/map/map_movement.hpp"
#include "stages/map/placement.hpp"
#include "stages/reconstruct/human_limits.hpp"
#include "stages/scene/move_target.hpp"
#include "stages/scene/scene_flags.hpp"

namespace morphe::planning {
namespace {

/// A movement with its motion, its scene and the offset of the base, before the robot is placed.
struct PreparedMovement {
  Plan begun;               ///< identifies the movement
  PlanningFailure failure;  ///< set if the robot cannot be placed
  PlanningFailure refusal;  ///< set if it can, but its goals should not be followed
  HumanMotion motion;
  Scene around;                ///< in the frame of `motion`
  Vec3 offset = Vec3::Zero();  ///< of the base from its placement [m]
  std::uint64_t seed = 0;
};

/// Returns the names of recorded objects that are the person's other arm, not a target.
std::vector<std::string> obstacle_names(const scene::SceneOptions& options) {
  if (!options.other_arm) return {};
  return {scene::kOtherArmNames.begin(), scene::kOtherArmNames.end()};
}

/// Returns true if a fingertip has a goal in a frame of grasp or hold, or no frame is in them.
bool has_grasp_goal(const Goals& goals, const Movement& movement) {
  bool grasp_seen = false;
  for (std::size_t f = 0; f < goals.frames(); ++f) {
    if (!is_grasping_at(movement, goals.time[f])) continue;
    grasp_seen = true;
    for (std::size_t tip = 0; tip < goals.tip_position.cols; ++tip) {
      if (is_known(goals.tip_position(f, tip))) return true;
    }
  }
  return !grasp_seen;
}

/// Adds the doubts about the objects around a movement to its plan. A hand without an arm has none.
void add_scene_flags(const PlanningInputs& planner, const Demonstration& demonstration,
                     const HumanMotion& motion, const Scene& scene, Plan& plan) {
  if (map::is_hand_only(planner.robot)) return;
  std::vector<RecordingFlag> flags =
      scene::scene_flags(planner.config.scene, demonstration, motion, plan.movement, scene);
  imports::accept_flags(demonstration, flags);
  plan.flags.insert(plan.flags.end(), flags.begin(), flags.end());
}

PreparedMovement prepare(const PlanningInputs& planner, const Demonstration& demonstration,
                         const HumanMotion& recorded, const Movement& movement,
                         const std::optional<Vec3>& known_offset) {
  const PipelineConfig& config = planner.config;
  PreparedMovement setting;
  setting.begun = begin_plan(demonstration, movement, config.check.tolerances);
  setting.seed =
      math::seed_from(config.seed, "movement");  // the same for all: a name decides nothing
  if (!map::is_hand_only(planner.robot) && !is_known(map::shoulder_at_begin(recorded, movement))) {
    setting.failure = {Reason::no_shoulder, "the shoulder was never seen"};
    return setting;
  }
  setting.failure = reconstruct::check_human_limits(recorded, config.human);
  if (setting.failure) return setting;
  const Goals goals = map::make_goals(planner.robot, recorded, movement, Pose::Identity());
  setting.begun.flags = planner.timed("audit", [&] {
    return imports::audit_movement({demonstration, recorded, movement, goals,
                                    config.scene.target.name, obstacle_names(config.scene)},
                                   config.audit);
  });
  Movement& placed = setting.begun.movement;
  scene::RelocatedMovement relocated = planner.timed("scene", [&] {
    const Scene as_recorded = scene_around(planner, demonstration, recorded, placed);
    add_scene_flags(planner, demonstration, recorded, as_recorded, setting.begun);
    return scene::move_target(config.scene, recorded, placed, as_recorded);
  });
  if (!has_grasp_goal(goals, movement)) {
    setting.refusal = {Reason::no_goal, "no fingertip was seen in the grasp"};
  } else if (const auto* refused = imports::refused_flag(setting.begun.flags, config.audit)) {
    setting.refusal = {Reason::doubtful_recording, refused->text};
  } else {
    setting.refusal = refused_assumption(config.must_be_known, setting.begun, relocated.scene);
  }
  setting.motion = std::move(relocated.motion);
  setting.around = std::move(relocated.scene);
  setting.offset = known_offset.value_or(Vec3::Zero());
  if (config.map.base_offset.limit_m > 0 && !known_offset && !setting.refusal) {
    setting.offset = planner.timed("map", [&] {
      return choose_offset(planner, setting.motion, placed, setting.around,
                           math::seed_from(setting.seed, "offset"));
    });
  }
  return setting;
}

/// Sets the plan's trajectory and certificate, or fails it. If smoothing makes the path collide
/// or moves tips too far from their goals, a second attempt is made without it.
void retime_and_certify(const PlanningInputs& planner, const collision::CollisionWorld& world,
                        Plan& plan) {
  const auto attempt = [&](const retime::RetimeOptions& options) -> PlanningFailure {
    Outcome<retime::RetimeResult> retimed = planner.timed(
        "retime", [&] { return retime::retime(planner.robot, plan.path, plan.movement, options); });
    plan.certificate = {};
    if (retimed.failure) return retimed.failure;
    plan.trajectory = std::move(retimed.value.trajectory);
    Outcome<Certificate> certified = planner.timed("certify", [&] {
      return certify::certify(world, plan.goals, plan.movement, plan.trajectory, plan.mapped);
    });
    plan.certificate = std::move(certified.value);
    return certified.failure;
  };
  const PlanningFailure failure = retry_without_smoothing(
      planner.config.retime, {Reason::smoothing_collision, Reason::tracking}, attempt);
  plan.reason = Reason::none;
  if (failure) plan = fail(std::move(plan), failure);
}

/// Adds approach, grasp and warnings to an executable plan; fails it if there is no approach.
void add_grasp_and_approach(const PlanningInputs& planner, const PreparedMovement& setting,
                            const Contacts& contacts, const collision::CollisionWorld& world,
                            Plan& plan) {
  const PipelineConfig& config = planner.config;
  const std::string approximate_reason =
      certify::approximate_reason(plan.goals, plan.movement, plan.tolerances, plan.certificate);
  plan.approximate = !approximate_reason.empty();
  if (config.approach) {
    const PlanningFailure refused = planner.timed(
        "approach", [&] { return add_approach(planner, *config.approach, setting.seed, plan); });
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
  if (config.grasp) {
    const grasp::HeldDrift drift = grasp::held_drift(planner.robot, plan);
    plan.certificate.held_drift = drift.displacement_m;
    plan.certificate.held_turn = drift.turn_rad;
    if (const PlanningFailure lost = grasp::check_held(planner.robot, plan)) {
      plan = fail(std::move(plan), lost);
      return;
    }
  }
  plan.detail = approximate_reason;
  for (const std::string& sentence :
       {warnings(world, plan.goals, plan.movement, setting.motion, plan.trajectory,
                 config.retime.mode == retime::RetimeMode::catch_up),
        join_sentences(contacts.notes), near_contacts_warning(plan.grasp),
        grasp_force_warning(plan.grasp),
        config.grasp ? "" : unchecked_carrying_warning(plan.movement),
        humanlikeness_warning(plan.certificate, plan.goals),
        unchecked_sentence(planner.robot.unchecked_links)}) {
    if (!sentence.empty()) plan.detail += (plan.detail.empty() ? "" : "; ") + sentence;
  }
}

/// Retimes and certifies a plan whose path is free, and adds its grasp and its approach.
void complete_plan(const PlanningInputs& planner, const PreparedMovement& setting,
                   const Contacts& contacts, const collision::CollisionWorld& world, Plan& plan) {
  retime_and_certify(planner, world, plan);
  if (plan.has_trajectory()) add_grasp_and_approach(planner, setting, contacts, world, plan);
}

/// Returns true if contacts may remove all findings of the path: they are collisions with the
/// target, or the hand will follow a target that it carries instead of the person's tips.
bool can_use_contacts(const PlanningInputs& planner, const Plan& plan) {
  if (grasp::must_be_held(planner.robot, plan.movement)) return true;
  return std::ranges::all_of(plan.remaining_findings, [&](const Finding& finding) {
    return finding.other_body == plan.movement.target;
  });
}

/// Returns the complete plan with contacts according to the section `grasp`, whose tolerances
/// `world` has. If the contacts are given up, returns the plan that follows the tips, kept out of
/// the target according to the same tolerances; with `refused_by_tips`, a failed plan.
/// `world` refers to the scene of `by_tips`.
Plan plan_with_contacts(const PlanningInputs& planner, const PreparedMovement& setting,
                        const collision::CollisionWorld& world, const Plan& by_tips,
                        const PlanningFailure& refused_by_tips) {
  const Contacts demonstrated =
      planner.timed("grasp", [&] { return demonstrated_contacts(planner, world, by_tips); });
  Plan start = by_tips;
  start.tolerances = world.tolerances;
  std::vector<std::string> notes = demonstrated.notes;
  if (!demonstrated.contacts.empty()) {
    Outcome<ContactPlan> touching = planner.timed("grasp", [&] {
      return plan_contacts(planner, world, setting.seed, demonstrated.contacts, start);
    });
    PlanningFailure failure = std::move(touching.failure);
    if (!failure) {
      Plan& plan = touching.value.plan;
      complete_plan(planner, setting, touching.value.contacts, world, plan);
      if (plan.has_trajectory()) return std::move(plan);
      failure = {plan.reason, plan.detail};
    }
    notes = {given_up_sentence({}, failure)};
    if (grasp::must_be_held(planner.robot, by_tips.movement)) {
      failure.detail +=
          fmt::format("; {} is carried, so its contacts are not given up", by_tips.movement.target);
      return fail(std::move(start), failure);
    }
  }
  if (refused_by_tips) return fail(by_tips, refused_by_tips);
  Outcome<Plan> outside = planner.timed(
      "grasp", [&] { return plan_without_contacts(planner, world, setting.seed, start); });
  if (outside.failure) return fail(std::move(outside.value), outside.failure);
  complete_plan(planner, setting, {{}, std::move(notes)}, world, outside.value);
  return std::move(outside.value);
}

/// Returns the scene of a path that follows the tips and is replaced by one with contacts: the
/// target moves as it was recorded, but is not yet a body that the hand carries.
Scene scene_before_contacts(const Plan& plan) {
  Scene scene = plan.scene;
  SceneObject* target = find_object(scene.objects, plan.movement.target);
  if (target) {
    target->attached_frame.clear();
    target->attach_s = target->release_s = kUnknown;
  }
  return scene;
}

/// Returns the plan with its scene and its goals; failed if the movement should not be followed.
Plan placed_plan(const PreparedMovement& setting, const PlacedMovement& placed) {
  Plan plan = setting.begun;
  plan.scene = placed.scene;
  plan.reference_frames = placed.frames;
  plan.goals = placed.goals;
  if (!placed.missing_support.empty())
    return fail(std::move(plan), {Reason::no_reference_frame, placed.missing_support});
  if (setting.refusal) return fail(std::move(plan), setting.refusal);
  return plan;
}

/// Plans a movement with the distances from obstacles that the config states.
Plan plan_as_configured(const PlanningInputs& planner, const Demonstration& demonstration,
                        const HumanMotion& recorded, const Movement& movement,
                        const std::optional<Vec3>& known_offset) {
  const PipelineConfig& config = planner.config;
  const PreparedMovement setting =
      prepare(planner, demonstration, recorded, movement, known_offset);
  if (setting.failure) return fail(setting.begun, setting.failure);
  PlacedMovement placed(planner, setting.motion, setting.begun.movement, setting.around,
                        setting.offset);
  Plan plan = placed_plan(setting, placed);
  if (plan.reason != Reason::unplanned) return plan;
  const Scene scene = config.grasp ? scene_before_contacts(plan) : plan.scene;
  collision::CollisionWorld world = collision::make_world(planner.robot, scene, plan.movement,
                                                          plan.tolerances, config.scene.meshes);
  Outcome<map::MapResult> mapping = planner.timed("map", [&] {
    return map::map_movement(placed.problem, plan.goals, config.map, setting.seed);
  });
  if (mapping.failure) return fail(std::move(plan), mapping.failure);
  map::MapResult& mapped = mapping.value;
  plan.mapped = std::move(mapped.mapped);
  plan.path = mapped.path;

  plan.findings = planner.timed("check", [&] {
    return check::check_path(world, plan.goals, plan.movement, plan.path, config.check);
  });
  PlanningFailure failure;
  if (!plan.findings.empty()) {
    Outcome<repair::RepairResult> repaired = planner.timed("repair", [&] {
      return repair_movement(planner, placed, world, plan, mapped, setting.seed);
    });
    plan.path = std::move(repaired.value.path);
    plan.repair = std::move(repaired.value.attempts);
    plan.remaining_findings = std::move(repaired.value.remaining);
    plan.repaired = repaired.value.repaired;
    failure = std::move(repaired.failure);
  }
  if (config.grasp && can_use_contacts(planner, plan)) {
    world.tolerances = tolerances_of(config);
    world.scene = &plan.scene;
    return plan_with_contacts(planner, setting, world, plan, failure);
  }
  if (failure) return fail(std::move(plan), failure);
  Plan in_tempo = planner.timed("repair", [&] { return keep_tempo(planner, placed, world, plan); });
  complete_plan(planner, setting, {}, world, in_tempo);
  const bool same_path = in_tempo.path.position == plan.path.position;
  if (same_path || in_tempo.has_trajectory()) return in_tempo;
  complete_plan(planner, setting, {}, world, plan);
  return plan;
}

/// Plans a movement as configured, or else farther from the obstacles.
Plan plan_or_plan_farther(const PlanningInputs& planner, const Demonstration& demonstration,
                          const HumanMotion& recorded, const Movement& movement,
                          const std::optional<Vec3>& known_offset) {
  Plan plan = plan_as_configured(planner, demonstration, recorded, movement, known_offset);
  if (plan.reason != Reason::smoothing_collision) return plan;
  const PipelineConfig config = farther_from_obstacles(planner.config);
  const PlanningInputs farther{config, planner.robot, planner.clock, planner.requirements};
  Plan second = plan_as_configured(farther, demonstration, recorded, movement, known_offset);
  if (!second.has_trajectory()) {
    plan.detail += "; a path farther from the obstacles has been tried";
    return plan;
  }
  const std::string note = fmt::format(
      "planned with map.clearance.activation_distance={} and repair.extra_clearance={}, because "
      "the "
      "smooth curve of the path collided ({})",
      config.map.clearance.activation_distance_m, config.repair.extra_clearance, plan.detail);
  second.detail += (second.detail.empty() ? "" : "; ") + note;
  return second;
}

}  // namespace

Plan place_movement(const PlanningInputs& planner, const Demonstration& demonstration,
                    const HumanMotion& recorded, const Movement& movement,
                    const Vec3& known_offset) {
  const PreparedMovement setting =
      prepare(planner, demonstration, recorded, movement, known_offset);
  if (setting.failure) return fail(setting.begun, setting.failure);
  const PlacedMovement placed(planner, setting.motion, setting.begun.movement, setting.around,
                              setting.offset);
  return placed_plan(setting, placed);
}

Plan plan_movement(const PlanningInputs& planner, const Demonstration& demonstration,
                   const HumanMotion& recorded, const Movement& movement,
                   const std::optional<Vec3>& known_offset) {
  Plan plan = plan_or_plan_farther(planner, demonstration, recorded, movement, known_offset);
  const std::string opening = opening_warning(planner.robot, plan.goals);
  if (!opening.empty()) plan.detail += (plan.detail.empty() ? "" : "; ") + opening;
  plan.branch = branch_of(planner.robot, plan);
  return plan;
}

}  // namespace morphe::planning
