#include "pipeline/planning/contacts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/collision/mesh_solid.hpp"
#include "core/math/seed.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "pipeline/planning/clearance_weights.hpp"
#include "pipeline/planning/re_solve.hpp"
#include "pipeline/planning/repair_movement.hpp"
#include "stages/check/check_path.hpp"
#include "stages/grasp/close_fingers.hpp"
#include "stages/grasp/demonstrated_contacts.hpp"
#include "stages/map/frame_search.hpp"
#include "stages/map/map_movement.hpp"
#include "stages/map/re_solve_path.hpp"

namespace morphe::planning {
namespace {

/// weights with the same clearance as in solving with high weights
constexpr ClearanceWeights kContactWeights{1000, 0.2};
/// relaxes the relative value, because the path is optimised only near another one
constexpr double kSettlingToleranceFactor = 10;

/// Time before closing until which the hand keeps clear of the target if possible, although contact
/// is allowed from the preshape on: fingers that slide along an object push it over [s].
constexpr double kTouchLeadTime_s = 0.3;

/// Limit for the distance of a moved contact point from the original one. A pad that does not reach
/// its contact point touches at its actual position instead, because contact matters more than its
/// position.
constexpr double kMaxContactShift_m = 0.015;
constexpr int kMaxMoves = 3;

/// A movement for which contacts with its target are planned.
struct ContactContext {
  const PlanningInputs& planner;
  const collision::CollisionWorld& world;
  const SceneObject& target;
  std::uint64_t seed;

  collision::Solid solid() const { return collision::solid_at(world, world.target); }
};

/// The contacts and constraints requested of the tips.
struct ContactRequest {
  std::vector<grasp::DesiredContact> contacts;
  std::vector<std::string> given_up;      ///< tips without contact
  std::vector<std::size_t> kept_outside;  ///< tips whose goals are kept outside of the target
  std::vector<std::string> moved;         ///< tips whose contact has been moved
  int moves = 0;
};

/// A plan with the contacts of some tips, or without contacts, and the reason if it cannot be
/// executed.
struct ContactAttempt {
  Plan plan;
  Contacts contacts;
  PlanningFailure failure;
};

/// Returns the mapping problem of the attempt's goals, including the directions of the pads.
map::MappingProblem problem_of(const ContactContext& of, const ContactAttempt& attempt) {
  const Plan& plan = attempt.plan;
  map::MappingProblem problem = map::make_mapping_problem(
      of.planner.robot, plan.goals, of.world, of.planner.config.map, plan.movement.phases);
  for (std::size_t f = 0; f < problem.frames(); ++f) {
    const Eigen::Matrix3d turn = recorded_pose(of.target, problem.time[f]).linear();
    std::vector<Vec3>& normals = problem.goals[f].pad_normal;
    normals.assign(of.planner.robot.tips.size(), unknown_point());
    for (const grasp::DesiredContact& touch : attempt.contacts.contacts) {
      if (touch.origin == ContactOrigin::demonstrated) normals[touch.tip] = turn * touch.normal;
    }
  }
  return problem;
}

/// Returns the frame in which the hand has grasped the target; frames() if there is no such frame.
std::size_t frame_of_grasp(const Goals& goals, const grasp::HoldInterval& when) {
  const auto at = std::ranges::lower_bound(goals.time, when.begin_s);
  return at - goals.time.begin();
}

/// Sets the goals of pads and closed fingers, and the initial path: the previous one, blended
/// increasingly with a posture in contact.
void aim_hand(const ContactContext& of, const std::vector<std::string>& given_up,
              ContactAttempt& attempt) {
  const robot::Robot& robot = of.planner.robot;
  Goals& goals = attempt.plan.goals;
  const grasp::HoldInterval when = grasp::hold_interval(attempt.plan.movement);
  const std::size_t frame = frame_of_grasp(goals, when);
  grasp::set_pad_goals(robot, attempt.contacts.contacts, attempt.plan.movement, of.solid(),
                       of.planner.config.grasp->preshape_clearance_m, goals);
  if (frame == goals.frames()) return;
  JointRows& path = attempt.plan.path.position;
  const JointVector before = path.row(frame).transpose();
  map::MappingScratch scratch;
  const JointVector touching =
      map::solve_frame(with_clearance_weights(problem_of(of, attempt), kContactWeights), frame,
                       before, of.planner.config.map.frame_solver, scratch)
          .x;
  for (std::size_t f = 0; f < goals.frames(); ++f) {
    const double share = grasp::closing_progress(when, goals.time[f]);
    if (share == 0) continue;
    path.row(f) += share * (touching - before).transpose();
  }
  if (!of.planner.config.grasp->close_fingers) return;
  std::vector<std::size_t> tips = grasp::tips_without_goals(robot, goals, when);
  std::erase_if(tips, [&](std::size_t tip) {
    return std::ranges::find(given_up, robot.tips[tip].name) != given_up.end();
  });
  const grasp::FingerClosures closed =
      grasp::close_fingers(of.world, goals.time[frame], tips, touching);
  std::ranges::copy(closed.open_reasons, std::back_inserter(attempt.contacts.notes));
  grasp::set_closure_goals(robot, closed.closings, attempt.plan.movement, of.target, path, goals);
  for (const grasp::FingerClosure& closing : closed.closings) {
    attempt.contacts.contacts.push_back(closing.contact);
  }
}

/// Optimises the whole path locally. It includes the frames before the hand shapes, because the
/// wrist begins to turn earlier.
JointRows settle_path(const ContactContext& of, const ContactAttempt& attempt) {
  const Plan& plan = attempt.plan;
  const grasp::HoldInterval when = grasp::hold_interval(plan.movement);
  collision::CollisionWorld keeping_off = of.world;
  keeping_off.touch_begin_s = std::max(of.world.touch_begin_s, when.begin_s - kTouchLeadTime_s);
  map::MapOptions options = of.planner.config.map;
  options.movement_solver.relative_tolerance *= kSettlingToleranceFactor;
  const map::MappingProblem problem = with_clearance_weights(
      problem_of({of.planner, keeping_off, of.target, of.seed}, attempt), kContactWeights);
  return map::re_solve_between(problem, plan.path, plan.movement.begin_s, plan.movement.end_s,
                               options)
      .position;
}

ContactAttempt try_out(const ContactContext& of, const ContactRequest& wanted,
                       const Plan& by_tips) {
  const PipelineConfig& config = of.planner.config;
  ContactAttempt attempt{by_tips, {wanted.contacts, {}}, {}};
  Plan& plan = attempt.plan;
  grasp::keep_goals_outside(of.planner.robot, wanted.kept_outside, plan.movement, of.solid(),
                            plan.goals);
  if (!wanted.contacts.empty()) aim_hand(of, wanted.given_up, attempt);
  const map::MappingProblem problem = problem_of(of, attempt);
  plan.path.position = settle_path(of, attempt);
  const JointRows mapped = plan.path.position;
  const collision::CollisionWorld roomy = with_extra_margin(of.world);
  const auto findings_in = [&](const collision::CollisionWorld& world, const JointPath& path) {
    return check::check_path(world, plan.goals, plan.movement, path, config.check);
  };
  const ReSolveContext solving{problem, config.map,
                               [&](const JointPath& path) { return findings_in(roomy, path); }};
  plan.remaining_findings = findings_in(roomy, plan.path);
  if (!plan.remaining_findings.empty()) {
    Outcome<repair::RepairResult> freed =
        repair::repair_path({repair::only_if_nearly_free(re_solve_strongly(solving))},
                            {plan.path, plan.remaining_findings});
    plan.path = std::move(freed.value.path);
    plan.certificate.repaired = true;
    std::ranges::move(freed.value.attempts, std::back_inserter(plan.repair));
    plan.remaining_findings = findings_in(of.world, plan.path);
    if (!plan.remaining_findings.empty()) {
      attempt.failure = std::move(freed.failure);
      return attempt;
    }
  }
  map::MapResult judged = map::evaluate_path(problem, plan.goals, mapped, config.map,
                                             math::seed_from(of.seed, "contacts"));
  plan.mapped = std::move(judged.mapped);
  plan.certificate.natural_posture_error = judged.posture_error_rad;
  return attempt;
}

/// Moves the contacts of tips that only tracking prevents from touching to the positions of their
/// pads in the grasp. Returns false if there are no such tips. `first` contains the original
/// contacts.
bool move_touches(const ContactContext& of, const ContactAttempt& attempt,
                  const std::vector<grasp::DesiredContact>& first, ContactRequest& wanted) {
  const Plan& plan = attempt.plan;
  const robot::Robot& robot = of.planner.robot;
  const std::size_t frame = frame_of_grasp(plan.goals, grasp::hold_interval(plan.movement));
  if (frame == plan.goals.frames() || wanted.moves == kMaxMoves) return false;
  if (std::ranges::any_of(plan.remaining_findings, is_collision, &Finding::cause)) return false;
  std::vector<Pose> base_from_frame;
  robot::forward_kinematics(robot, plan.path.position.row(frame).transpose(), base_from_frame);
  const Pose target_from_base = recorded_pose(of.target, plan.goals.time[frame]).inverse();
  bool any = false;
  for (grasp::DesiredContact& touch : wanted.contacts) {
    const std::string& tip = robot.tips[touch.tip].name;
    if (std::ranges::find(plan.remaining_findings, tip, &Finding::subject) ==
        plan.remaining_findings.end())
      continue;
    const Vec3 pad = robot::tracked_point(robot, base_from_frame, touch.tip, 1);
    const grasp::DesiredContact there =
        grasp::project_contact(robot, of.solid(), target_from_base * pad, touch);
    const auto at_first = std::ranges::find(first, touch.tip, &grasp::DesiredContact::tip);
    if ((there.point - at_first->point).norm() > kMaxContactShift_m) continue;
    if (std::ranges::find(wanted.moved, tip) == wanted.moved.end()) wanted.moved.push_back(tip);
    touch = there;
    any = true;
  }
  if (any) ++wanted.moves;
  return any;
}

/// Keeps the goals of tips that obstruct without having a contact outside of the target. Returns
/// false if there are no such tips, or they are outside already.
bool keep_more_outside(const robot::Robot& robot, const ContactAttempt& attempt,
                       ContactRequest& wanted) {
  bool more = false;
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    const auto touches = [&](const grasp::DesiredContact& touch) { return touch.tip == tip; };
    if (std::ranges::any_of(attempt.contacts.contacts, touches) ||
        std::ranges::find(wanted.kept_outside, tip) != wanted.kept_outside.end() ||
        !findings_concern_tip(robot, tip, attempt.plan.remaining_findings))
      continue;
    wanted.kept_outside.push_back(tip);
    more = true;
  }
  return more;
}

/// Removes the contacts of tips that obstruct. Returns false if there are no such tips.
bool give_up(const robot::Robot& robot, const ContactAttempt& attempt, ContactRequest& wanted) {
  std::vector<std::string> tips;
  for (const grasp::DesiredContact& touch : attempt.contacts.contacts) {
    if (findings_concern_tip(robot, touch.tip, attempt.plan.remaining_findings)) {
      tips.push_back(robot.tips[touch.tip].name);
    }
  }
  std::erase_if(wanted.contacts, [&](const grasp::DesiredContact& touch) {
    return std::ranges::find(tips, robot.tips[touch.tip].name) != tips.end();
  });
  std::erase_if(wanted.moved,
                [&](const std::string& tip) { return std::ranges::find(tips, tip) != tips.end(); });
  std::ranges::copy(tips, std::back_inserter(wanted.given_up));
  return !tips.empty();
}

}  // namespace

Contacts desired_contacts(const PlanningInputs& planner, const collision::CollisionWorld& world,
                          const Plan& plan) {
  const grasp::GraspOptions& options = *planner.config.grasp;
  if (world.target < 0) return {};
  if (planner.config.map.mode == map::MapMode::joint_to_joint) {
    return {{}, {"no contacts: joint-to-joint mapping does not track the tips"}};
  }
  const collision::Solid target = collision::solid_at(world, world.target);
  Contacts wanted{
      grasp::demonstrated_contacts(planner.robot, plan.goals, plan.movement, target, options), {}};
  grasp::separate_contacts(planner.robot, target, world.tolerances.required_clearance,
                           wanted.contacts);
  if (wanted.contacts.empty()) {
    wanted.notes = {fmt::format(
        "no contacts: no fingertip's skin was within {:.0f} mm of {} for {:.0f} % "
        "of the grasp",
        1e3 * options.touch_distance_m, target.object.name, 100 * options.min_contact_share)};
  }
  return wanted;
}

PlanningFailure plan_contacts(const PlanningInputs& planner, const collision::CollisionWorld& world,
                              std::uint64_t seed, Contacts& contacts, Plan& plan) {
  if (world.target < 0) return {};
  const SceneObject& target = plan.scene.objects[world.target];
  const ContactContext of{planner, world, target, seed};
  if (contacts.contacts.empty()) {
    plan.remaining_findings =
        check::check_path(world, plan.goals, plan.movement, plan.path, planner.config.check);
    if (plan.remaining_findings.empty()) return {};
  }
  ContactRequest wanted;
  wanted.contacts = contacts.contacts;
  const std::vector<grasp::DesiredContact> first = std::move(contacts.contacts);
  PlanningFailure why;
  while (true) {
    ContactAttempt attempt = try_out(of, wanted, plan);
    if (!attempt.failure) {
      std::ranges::move(attempt.contacts.notes, std::back_inserter(contacts.notes));
      if (!wanted.moved.empty()) {
        contacts.notes.push_back(fmt::format("contact of {} moved along the surface of {}",
                                             fmt::join(wanted.moved, ", "), target.name));
      }
      if (!wanted.given_up.empty()) {
        contacts.notes.push_back(given_up_sentence(wanted.given_up, why));
      }
      contacts.contacts = std::move(attempt.contacts.contacts);
      plan = std::move(attempt.plan);
      return {};
    }
    if (!why) why = attempt.failure;
    if (move_touches(of, attempt, first, wanted)) continue;
    const bool another = keep_more_outside(planner.robot, attempt, wanted) ||
                         give_up(planner.robot, attempt, wanted);
    if (another && (first.empty() || !wanted.contacts.empty())) continue;
    contacts = {{}, {given_up_sentence({}, why)}};
    if (!first.empty()) return why;
    plan = std::move(attempt.plan);
    return {attempt.failure.reason,
            fmt::format("{}; the tips' goals are deeper in {} than pads and links may penetrate",
                        attempt.failure.detail, target.name)};
  }
}

bool findings_concern_tip(const robot::Robot& robot, std::size_t tip,
                          const std::vector<Finding>& findings) {
  const std::string& name = robot.tips[tip].name;
  const int pad = robot.pads[tip].capsule;
  const std::string link = pad < 0 ? "" : robot.capsules[pad].name;
  return std::ranges::any_of(findings, [&](const Finding& finding) {
    return finding.subject == name ||
           (pad >= 0 && (finding.subject == link || finding.other_body == link));
  });
}

std::string given_up_sentence(const std::vector<std::string>& tips,
                              const PlanningFailure& failure) {
  return fmt::format(
      "{} given up ({}): {}",
      tips.empty() ? "contacts" : fmt::format("contact of {}", fmt::join(tips, ", ")),
      name_of(failure.reason), failure.detail);
}

}  // namespace morphe::planning
