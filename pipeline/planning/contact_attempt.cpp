#include "pipeline/planning/contact_attempt.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/math/seed.hpp"
#include "pipeline/planning/close_hand.hpp"
#include "pipeline/planning/constants.hpp"
#include "pipeline/planning/contact_posture.hpp"
#include "pipeline/planning/held_path.hpp"
#include "pipeline/planning/re_solve.hpp"
#include "pipeline/planning/repair_movement.hpp"
#include "stages/check/check_path.hpp"
#include "stages/grasp/closure_goals.hpp"
#include "stages/grasp/demonstrated_contacts.hpp"
#include "stages/grasp/held_goals.hpp"
#include "stages/map/map_movement.hpp"
#include "stages/map/re_solve_path.hpp"

namespace morphe::planning {
namespace {

bool carries_target(const Movement& movement) { return !std::isnan(carrying_begin_s(movement)); }

/// Returns the mapping problem of the attempt's goals, with the contacts' normals for their pads.
map::MappingProblem problem_of(const ContactContext& context,
                               const collision::CollisionWorld& world,
                               const ContactAttempt& attempt) {
  const Plan& plan = attempt.plan;
  const robot::Robot& robot = context.planner.robot;
  map::MappingProblem problem = map::make_mapping_problem(
      robot, plan.goals, world, context.planner.config.map, plan.movement.phases);
  problem.objective.get<humanlike::PadDirection>().weight *= kPadDirectionFactor;
  const grasp::HoldInterval hold = grasp::hold_interval(plan.movement);
  const bool is_holding = attempt.held.size() > 0;
  if (is_holding) {
    const double weight = carries_target(plan.movement) ? kHeldHandWeight : kClosedHandWeight;
    hold_joints(hold, attempt.held, weight, problem);
  }
  for (std::size_t f = 0; f < problem.frames(); ++f) {
    const Eigen::Matrix3d target_rotation = recorded_pose(context.target, problem.time[f]).linear();
    std::vector<Vec3>& normals = problem.goals[f].pad_normal;
    const bool is_rigid =
        is_holding && carries_target(plan.movement) && grasp::is_held_at(hold, problem.time[f]);
    if (is_rigid) {
      normals.clear();  // they cannot change
      continue;
    }
    normals.assign(robot.tips.size(), unknown_point());
    for (const grasp::DesiredContact& contact : attempt.contacts) {
      if (contact.origin == ContactOrigin::demonstrated)
        normals[contact.tip] = target_rotation * contact.normal;
    }
  }
  return problem;
}

void set_pad_goals(const ContactContext& context, ContactAttempt& attempt) {
  grasp::set_pad_goals(context.planner.robot, attempt.contacts, attempt.plan.movement,
                       context.solid(), context.planner.config.grasp->preshape_clearance_m,
                       attempt.plan.goals);
}

/// Returns the posture of the grasp in which the pads of the attempt's contacts touch, solved from
/// `start` with the weights of a posture in contact. Joints keep their positions with the weights
/// `stay` [n].
ContactPosture touching_posture(const ContactContext& context, const ContactAttempt& attempt,
                                std::size_t frame, const JointVector& start,
                                const JointVector& stay) {
  return solve_contact_posture(
      with_clearance_weights(problem_of(context, context.world, attempt), kContactPostureWeights),
      frame, attempt.contacts, start, stay, context.planner.config.map, context.seed);
}

/// Returns weights with which the fingers move freely, and the arm hardly.
JointVector stay_weights_of_arm(const robot::Robot& robot) {
  JointVector stay = JointVector::Zero(static_cast<Eigen::Index>(robot.joints()));
  for (const int joint : robot.arm_joints) stay[joint] = kContactArmWeight;
  return stay;
}

/// Closes the fingers without goals at the frame of the grasp, in the posture `touching` too.
void close_other_fingers(const ContactContext& context, const std::vector<std::string>& given_up,
                         std::size_t frame, JointVector& touching, ContactAttempt& attempt) {
  const robot::Robot& robot = context.planner.robot;
  std::vector<std::size_t> tips = grasp::tips_without_goals(
      robot, attempt.plan.goals, grasp::hold_interval(attempt.plan.movement));
  std::erase_if(tips, [&](std::size_t tip) {
    return std::ranges::find(given_up, robot.tips[tip].name) != given_up.end();
  });
  ContactPosture closed{touching, attempt.contacts};
  attempt.notes = close_hand(
      with_clearance_weights(problem_of(context, context.world, attempt), kContactPostureWeights),
      frame, tips, context.planner.config.map, context.seed, closed);
  touching = std::move(closed.q);
  attempt.contacts = std::move(closed.contacts);
}

/// Lets the hand keep the posture `touching` until the release, and the arm follow the target.
void hold_target(const ContactContext& context, std::size_t frame, const JointVector& touching,
                 ContactAttempt& attempt) {
  Plan& plan = attempt.plan;
  grasp::set_held_goals(context.planner.robot, attempt.contacts, touching, frame, plan.movement,
                        context.target, plan.goals);
  const map::MappingProblem problem =
      with_clearance_weights(problem_of(context, context.world, attempt), kContactWeights);
  follow_target(problem, frame, touching, context.planner.config.map, plan.path.position);
}

/// Sets the goals of pads and closed fingers, and the path from which to optimise: the previous one
/// plus, times closing_progress(), its difference from a posture in contact at the grasp.
void aim_hand(const ContactContext& context, const std::vector<std::string>& given_up,
              ContactAttempt& attempt) {
  const PipelineConfig& config = context.planner.config;
  Goals& goals = attempt.plan.goals;
  const grasp::HoldInterval hold = grasp::hold_interval(attempt.plan.movement);
  const std::size_t frame = frame_of_grasp(goals, hold);
  if (frame == goals.frames()) {
    set_pad_goals(context, attempt);
    return;
  }
  JointRows& path = attempt.plan.path.position;
  const JointVector before = path.row(frame).transpose();
  const Goals of_tips = goals;
  set_pad_goals(context, attempt);
  ContactPosture posture =
      touching_posture(context, attempt, frame, before, stay_weights_of_arm(context.planner.robot));
  attempt.contacts = std::move(posture.contacts);
  if (config.grasp->close_fingers)
    close_other_fingers(context, given_up, frame, posture.q, attempt);
  const JointVector& touching = posture.q;
  for (std::size_t f = 0; f < goals.frames(); ++f) {
    const double progress = grasp::closing_progress(hold, goals.time[f]);
    if (progress == 0) continue;
    path.row(f) += progress * (touching - before).transpose();
  }
  goals = of_tips;
  set_pad_goals(context, attempt);
  grasp::set_closure_goals(context.planner.robot, attempt.contacts, attempt.plan.movement,
                           context.target, path, goals);
  attempt.held = touching;
  for (const int joint : context.planner.robot.arm_joints) attempt.held[joint] = kUnknown;
  if (carries_target(attempt.plan.movement)) hold_target(context, frame, touching, attempt);
}

/// Returns the whole path, optimised locally with kContactWeights. The frames before the preshape
/// are included, because the wrist begins to turn earlier.
JointRows settle_path(const ContactContext& context, const ContactAttempt& attempt) {
  const Plan& plan = attempt.plan;
  collision::CollisionWorld world = context.world;
  world.touch_begin_s =
      std::max(world.touch_begin_s, grasp::hold_interval(plan.movement).begin_s - kTouchLeadTime_s);
  collision::attach_target(plan.path.demonstration_time, plan.path.position, world);
  const map::MappingProblem problem =
      with_clearance_weights(problem_of(context, world, attempt), kContactWeights);
  return map::re_solve_between(problem, plan.path, plan.movement.begin_s, plan.movement.end_s,
                               context.planner.config.map)
      .position;
}

/// Solves the plan's path again with high weights if it is only nearly free, with kExtraMargin_m at
/// first. `problem` keeps the pads on their contacts as settle_path() did. Returns the reason if
/// findings remain without this margin.
PlanningFailure free_path(const ContactContext& context, const map::MappingProblem& problem,
                          Plan& plan) {
  const PipelineConfig& config = context.planner.config;
  const auto findings_in = [&](const collision::CollisionWorld& world, const JointPath& path) {
    return check::check_path(world, plan.goals, plan.movement, path, config.check);
  };
  const collision::CollisionWorld with_margin = with_extra_margin(context.world);
  const ReSolveContext re_solving{
      problem, config.map, [&](const JointPath& path) { return findings_in(with_margin, path); }};
  plan.remaining_findings = findings_in(with_margin, plan.path);
  if (plan.remaining_findings.empty()) return {};
  Outcome<repair::RepairResult> freed =
      repair::repair_path({repair::only_if_nearly_free(re_solve_strongly(re_solving))},
                          {plan.path, plan.remaining_findings});
  plan.path = std::move(freed.value.path);
  plan.repaired = true;
  std::ranges::move(freed.value.attempts, std::back_inserter(plan.repair));
  plan.remaining_findings = findings_in(context.world, plan.path);
  return plan.remaining_findings.empty() ? PlanningFailure{} : freed.failure;
}

}  // namespace

std::size_t frame_of_grasp(const Goals& goals, const grasp::HoldInterval& hold) {
  return std::ranges::lower_bound(goals.time, hold.begin_s) - goals.time.begin();
}

ContactAttempt try_contacts(const ContactContext& context, const ContactRequest& request,
                            const Plan& by_tips) {
  const PlanningInputs& planner = context.planner;
  ContactAttempt attempt{by_tips, request.contacts, {}, {}, {}};
  Plan& plan = attempt.plan;
  grasp::keep_goals_outside(planner.robot, request.kept_outside, plan.movement, context.solid(),
                            plan.goals);
  if (!request.contacts.empty()) aim_hand(context, request.given_up, attempt);
  const map::MappingProblem problem = problem_of(context, context.world, attempt);
  plan.path.position = settle_path(context, attempt);
  const JointRows mapped = plan.path.position;
  attempt.failure =
      free_path(context, with_clearance_weights(problem, {1, 1, kContactWeights.tips}), plan);
  if (attempt.failure) return attempt;
  // The path for the tips may have been changed by a repair that did not free it.
  plan.repaired = std::ranges::any_of(
      plan.path.origin, [](SampleOrigin origin) { return origin != SampleOrigin::mapped; });
  plan.mapped = map::evaluate_path(problem, plan.goals, mapped, planner.config.map,
                                   math::seed_from(context.seed, "contacts"))
                    .mapped;
  return attempt;
}

}  // namespace morphe::planning
