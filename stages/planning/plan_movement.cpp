#include "stages/planning/plan_movement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

#include "pipeline/collision/mesh_solid.hpp"
#include "pipeline/math/seed.hpp"
#include "pipeline/motion/arm_estimated.hpp"
#include "pipeline/parallel/ordered_map.hpp"
#include "pipeline/robot/hand_bones.hpp"
#include "stages/certify/certify.hpp"
#include "stages/certify/grasp.hpp"
#include "stages/certify/only_near.hpp"
#include "stages/grasp/close_fingers.hpp"
#include "stages/grasp/measure.hpp"
#include "stages/grasp/quality.hpp"
#include "stages/map/map_movement.hpp"
#include "stages/planning/approach.hpp"
#include "stages/planning/place_movement.hpp"
#include "stages/planning/plan_parts.hpp"
#include "stages/planning/repair_movement.hpp"
#include "stages/reconstruct/hand_frame.hpp"
#include "stages/reconstruct/human_limits.hpp"
#include "stages/reconstruct/mirror.hpp"
#include "stages/scene/move_target.hpp"

namespace morphe::planning {
namespace {

/// Adds the wall clock of one step to the summary's stage_seconds.
template <class Step>
auto timed(StageSeconds& seconds, const char* stage, const Step& step) {
  const auto begin = std::chrono::steady_clock::now();
  auto result = step();
  seconds[stage] += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

Plan begin_plan(const Demonstration& demonstration, const Movement& movement,
                const Tolerances& tolerances) {
  Plan plan;
  plan.demonstration = demonstration.name;
  plan.subject = demonstration.subject;
  plan.task = demonstration.task;
  plan.hand = demonstration.hand;
  plan.movement = movement;
  plan.tolerances = tolerances;
  return plan;
}

Plan fail(Plan plan, Refusal refusal) {
  plan.reason = refusal.reason;
  plan.detail = std::move(refusal.detail);
  plan.approximate = false;
  plan.trajectory = plan.approach = plan.retreat = {};
  return plan;
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

std::string joined(const std::vector<std::string>& sentences) {
  return fmt::format("{}", fmt::join(sentences, "; "));
}

/// How well the demonstration's time base is kept.
std::string lateness(const Trajectory& trajectory) {
  constexpr double kOnTime_s = 0.01;
  double most_s = 0, late_s = 0;
  for (std::size_t i = 1; i < trajectory.samples(); ++i) {
    const double late = trajectory.time[i] - trajectory.time[0] -
                        (trajectory.demonstration_time[i] - trajectory.demonstration_time[0]);
    most_s = std::max(most_s, late);
    if (late > kOnTime_s) late_s += trajectory.time[i] - trajectory.time[i - 1];
  }
  return fmt::format("late by up to {:.2f} s, for {:.2f} s by more than {:.2f}", most_s, late_s,
                     kOnTime_s);
}

/// What a user must know of an executable plan: tips whose goals are missing in some frames, a hand
/// of which one tip alone was seen, meshes with holes, phases that may begin or end elsewhere (a
/// recording that is cut off in them), and what reconstruction had to complain of.
std::string warnings(const collision::CollisionWorld& world, const Goals& goals,
                     const Movement& movement, const HumanMotion& motion,
                     const Trajectory& trajectory, bool kept) {
  constexpr double kUncertain = 0.5;
  const robot::Robot& robot = *world.robot;
  std::vector<std::string> sentences, asked;
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    std::size_t count = 0;
    if (!goals.closed.empty() && goals.closed[tip] != 0) continue;
    for (std::size_t f = 0; f < goals.frames(); ++f) count += seen(goals.tip_position(f, tip));
    if (count > 0) asked.push_back(robot.tips[tip].name);
    if (count > 0 && count < goals.frames()) {
      sentences.push_back(fmt::format("{} has a goal in {} of {} frames", robot.tips[tip].name,
                                      count, goals.frames()));
    }
  }
  if (goals.hand_scale != 1) {
    sentences.push_back(
        fmt::format("the human's hand is made {:.3g} times as large", goals.hand_scale));
  }
  if (goals.free_offset) {
    const Vec3 moved = 1e3 * *goals.free_offset;
    sentences.push_back(fmt::format("the base is moved by ({:.0f}, {:.0f}, {:.0f}) mm", moved.x(),
                                    moved.y(), moved.z()));
  }
  for (std::size_t k = 0; k < world.meshes.size(); ++k) {
    if (world.meshes[k] && collision::is_open(*world.meshes[k])) {
      sentences.push_back(world.scene->objects[k].name + " is not closed: only its surface counts");
    }
  }
  if (kept && !trajectory.time.empty()) sentences.push_back(lateness(trajectory));
  if (asked.size() == 1) sentences.push_back("no tip but " + asked.front() + " has goals");
  for (const Phase& phase : movement.phases) {
    if (phase.begin_s > movement.end_s || phase.confidence > kUncertain) continue;
    sentences.push_back(fmt::format("{} begins or ends uncertainly ({:.0f} %)", name_of(phase.kind),
                                    100 * phase.confidence));
  }
  sentences.insert(sentences.end(), motion.problems.begin(), motion.problems.end());
  return joined(sentences);
}

/// "", or that the upper arm points elsewhere than the person's.
std::string not_humanlike(const Certificate& certificate, const Goals& goals) {
  constexpr double kFar = 45 * kDegree;
  if (!(certificate.upper_arm_error_mean > kFar)) return "";
  return fmt::format(
      "not humanlike: the upper arm is {}{:.0f} degrees from the person's{} in the mean (morphe "
      "place)",
      arm_estimated(goals) ? "~" : "", certificate.upper_arm_error_mean / kDegree,
      arm_estimated(goals) ? ", which is an estimate," : "");
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

/// Closes the fingers without goals onto the target, from where the mapped hand has taken it.
void close_other_fingers(const Planner& planner, const collision::CollisionWorld& world,
                         const std::vector<std::string>& given_up, Plan& plan,
                         PlacedMovement& placed, map::MapResult& mapped, std::uint64_t seed) {
  const grasp::HoldTime when = grasp::hold_time(plan.movement);
  const bool tips_count = planner.config.map.mode != map::MapMode::joint_to_joint;
  if (placed.touches.empty() || world.target < 0 || !tips_count) return;
  const auto at = std::ranges::lower_bound(plan.goals.time, when.begin_s);
  if (at == plan.goals.time.end()) return;
  const auto frame = at - plan.goals.time.begin();
  std::vector<std::size_t> tips = grasp::tips_without_goals(planner.robot, plan.goals, when);
  std::erase_if(tips, [&](std::size_t tip) {
    return std::ranges::find(given_up, planner.robot.tips[tip].name) != given_up.end();
  });
  const grasp::ClosedFingers closed =
      grasp::close_fingers(world, *at, tips, mapped.path.position.row(frame).transpose());
  const std::vector<grasp::Closing>& closings = closed.closings;
  placed.notes.insert(placed.notes.end(), closed.open.begin(), closed.open.end());
  if (closings.empty()) return;
  const SceneObject& target = world.scene->objects[static_cast<std::size_t>(world.target)];
  grasp::aim_closings(planner.robot, closings, plan.movement, target, mapped.path.position,
                      plan.goals);
  placed.problem = map::make_mapping_problem(planner.robot, plan.goals, placed.world,
                                             planner.config.map, plan.movement.phases);
  mapped = map::map_again(placed.problem, plan.goals, std::move(mapped), planner.config.map,
                          math::seed_from(seed, "closed"));
  for (const grasp::Closing& closing : closings) placed.touches.push_back(closing.touch);
}

Plan plan_with(const Contacts& contacts, const Planner& planner, const Demonstration& demonstration,
               const HumanMotion& recorded, const Movement& movement, StageSeconds& seconds,
               const std::optional<Vec3>& known_offset) {
  const PipelineConfig& config = planner.config;
  const robot::Robot& robot = planner.robot;
  Plan plan = begin_plan(demonstration, movement, tolerances_of(config, contacts));
  const std::uint64_t seed =
      math::seed_from(config.seed, fmt::format("{}/{}", demonstration.name, movement.index));

  if (!map::hand_alone(robot) && !seen(map::shoulder_at_begin(recorded, movement))) {
    return fail(plan, {Reason::no_shoulder, "the shoulder was never seen"});
  }
  if (const Refusal inhuman = reconstruct::refuse_inhuman(recorded, config.human)) {
    return fail(plan, inhuman);
  }
  const scene::MovedTarget there = timed(seconds, "scene", [&] {
    const Scene as_recorded = scene_around(planner, demonstration, recorded, plan.movement);
    return scene::move_target(config.scene, recorded, plan.movement, as_recorded);
  });
  const HumanMotion& motion = there.motion;
  const Scene& around = there.scene;
  Vec3 offset = known_offset.value_or(Vec3::Zero());
  if (config.map.free_offset.limit_m > 0 && !known_offset) {
    offset = timed(seconds, "map", [&] {
      return choose_offset(planner, motion, plan.movement, around, math::seed_from(seed, "offset"));
    });
  }
  PlacedMovement placed(planner, motion, plan.movement, around, offset, contacts);
  plan.scene = placed.scene;
  plan.world = placed.frames;
  plan.goals = placed.goals;
  if (!placed.nowhere.empty()) return fail(plan, {Reason::no_frame, placed.nowhere});
  if (!grasp_seen(plan.goals, plan.movement)) {
    return fail(plan, {Reason::no_goal, "no fingertip was seen in the grasp"});
  }
  const collision::CollisionWorld world =
      collision::make_world(robot, plan.scene, plan.movement, plan.tolerances, config.scene.meshes);
  Outcome<map::MapResult> mapping = timed(seconds, "map", [&] {
    return map::map_movement(placed.problem, plan.goals, config.map, seed);
  });
  if (mapping.refusal) return fail(plan, mapping.refusal);
  map::MapResult& mapped = mapping.value;
  if (contacts.asked && config.grasp->close_fingers) {
    timed(seconds, "map", [&] {
      close_other_fingers(planner, world, contacts.given_up, plan, placed, mapped, seed);
      return true;
    });
  }
  plan.mapped = std::move(mapped.mapped);
  plan.path = mapped.path;
  plan.certificate.natural_posture_error = mapped.posture_error_rad;

  plan.findings = timed(seconds, "check", [&] {
    return check::check_path(world, plan.goals, plan.movement, plan.path, config.check);
  });
  if (!plan.findings.empty()) {
    Outcome<repair::RepairResult> repaired = timed(seconds, "repair", [&] {
      return repair_movement(planner, placed, world, plan, mapped, seed);
    });
    plan.path = std::move(repaired.value.path);
    plan.repair = std::move(repaired.value.steps);
    plan.remaining = std::move(repaired.value.remaining);
    plan.certificate.repaired = repaired.value.repaired;
    if (repaired.refusal) return fail(plan, repaired.refusal);
  }
  finish(planner, world, plan, seconds);
  if (plan.has_trajectory()) {
    const std::string only_near = certify::only_near(plan.goals, plan.tolerances, plan.certificate);
    plan.approximate = !only_near.empty();
    if (config.approach) {
      const Refusal refused = timed(
          seconds, "approach", [&] { return add_approach(planner, *config.approach, seed, plan); });
      if (refused) return fail(plan, refused);
    }
    plan.grasp = certify::find_grasp(robot, plan.scene, plan.movement, plan.trajectory);
    if (plan.grasp.sample >= 0) {
      const auto sample = static_cast<std::size_t>(plan.grasp.sample);
      plan.grasp.contacts = grasp::measure_contacts(world, placed.touches, plan.grasp.hand_posture,
                                                    plan.trajectory.demonstration_time[sample]);
      if (config.grasp) {
        const Vec3 down = -plan.world.base_from_world.linear().col(2);
        grasp::judge_grasp(world, plan.trajectory.demonstration_time[sample], down, *config.grasp,
                           plan.grasp);
      }
    }
    plan.detail = only_near;
    for (const std::string& sentence :
         {warnings(world, plan.goals, plan.movement, motion, plan.trajectory,
                   config.retime.mode == retime::Tempo::kept),
          joined(placed.notes), not_humanlike(plan.certificate, plan.goals),
          unchecked_sentence(robot.unchecked_links)}) {
      if (!sentence.empty()) plan.detail += (plan.detail.empty() ? "" : "; ") + sentence;
    }
  }
  return plan;
}

/// Tips with contacts that what is left of a plan's findings speaks of: they are away from their
/// goals, or their links collide.
std::vector<std::string> tips_in_the_way(const robot::Robot& robot, const Plan& plan) {
  std::vector<std::string> tips;
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    bool touches = false;
    for (std::size_t f = 0; f < plan.goals.frames(); ++f) {
      touches = touches || plan.goals.pad_share(f, tip) > 0;
    }
    if (!touches) continue;
    const std::string &name = robot.tips[tip].name,
                      &link =
                          robot.capsules[static_cast<std::size_t>(robot.pads[tip].capsule)].name;
    const bool concerned = std::ranges::any_of(plan.remaining, [&](const Finding& finding) {
      return finding.first == name || finding.first == link || finding.second == link;
    });
    if (concerned) tips.push_back(name);
  }
  return tips;
}

}  // namespace

Plan plan_movement(const Planner& planner, const Demonstration& demonstration,
                   const HumanMotion& recorded, const Movement& movement, StageSeconds& seconds,
                   const std::optional<Vec3>& known_offset) {
  const auto planned = [&](const Contacts& contacts) {
    return plan_with(contacts, planner, demonstration, recorded, movement, seconds, known_offset);
  };
  if (!planner.config.grasp) return planned({});
  const Plan plan = planned({true, {}});
  if (plan.has_trajectory() || plan.goals.pad_share.rows == 0) return plan;
  for (const Contacts& fewer : {Contacts{true, tips_in_the_way(planner.robot, plan)}, Contacts{}}) {
    if (fewer.asked && fewer.given_up.empty()) continue;
    Plan another = planned(fewer);
    if (!another.has_trajectory()) continue;
    const std::string which =
        fewer.asked ? fmt::format("contact of {}", fmt::join(fewer.given_up, ", ")) : "contacts";
    another.detail += fmt::format("{}{} given up: {}, {}", another.detail.empty() ? "" : "; ",
                                  which, name_of(plan.reason), plan.detail);
    return another;
  }
  return plan;
}

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
