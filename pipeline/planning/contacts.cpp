#include "pipeline/planning/contacts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/collision/mesh_solid.hpp"
#include "core/math/seed.hpp"
#include "core/robot/forward.hpp"
#include "pipeline/planning/firmness.hpp"
#include "pipeline/planning/re_solve.hpp"
#include "pipeline/planning/repair_movement.hpp"
#include "stages/check/check_path.hpp"
#include "stages/grasp/close_fingers.hpp"
#include "stages/grasp/demonstrated.hpp"
#include "stages/map/frame_search.hpp"
#include "stages/map/map_movement.hpp"
#include "stages/map/resolve_path.hpp"

namespace morphe::planning {
namespace {

constexpr Firmness kFirm{1000, 0.2};  ///< the path keeps clear as where it is re-solved firmly
constexpr double kLessExact = 10;     ///< it settles beside another: values this much less exact

/// Before its last moments of closing the hand keeps off the target where it can, though touching
/// is allowed from the preshape on: fingers that rub along an object push it over [s].
constexpr double kClosing_s = 0.3;

/// A pad that does not come to where it is to touch, touches where it comes instead, if that is no
/// farther from where it was to touch at first: that it touches matters more than where.
constexpr double kFarthestMove_m = 0.015;
constexpr int kMoves = 3;

/// A movement whose tips are about to touch its target.
struct Approaching {
  const Planner& planner;
  const collision::CollisionWorld& world;
  const SceneObject& target;
  std::uint64_t seed;

  collision::Solid solid() const {
    return collision::solid_at(world, static_cast<std::size_t>(world.target));
  }
};

/// What is asked of the tips.
struct Wanted {
  std::vector<grasp::Touch> touches;
  std::vector<std::string> given_up;      ///< tips that do not touch any more
  std::vector<std::size_t> kept_outside;  ///< tips whose goals are kept out of the target
  std::vector<std::string> moved;         ///< tips that touch beside where they were to at first
  int moves = 0;
};

/// A plan with the contacts of some tips, or of none, and why it cannot be executed so.
struct Attempt {
  Plan plan;
  Contacts contacts;
  Refusal refusal;
};

/// Its goals, with the directions of pads beside them.
map::MappingProblem problem_of(const Approaching& of, const Attempt& attempt) {
  const Plan& plan = attempt.plan;
  map::MappingProblem problem = map::make_mapping_problem(
      of.planner.robot, plan.goals, of.world, of.planner.config.map, plan.movement.phases);
  for (std::size_t f = 0; f < problem.frames(); ++f) {
    const Eigen::Matrix3d turn = recorded_pose(of.target, problem.time[f]).linear();
    std::vector<Vec3>& normals = problem.goals[f].pad_normal;
    normals.assign(of.planner.robot.tips.size(), unseen_point());
    for (const grasp::Touch& touch : attempt.contacts.touches) {
      if (touch.origin == ContactOrigin::demonstrated) normals[touch.tip] = turn * touch.normal;
    }
  }
  return problem;
}

/// The frame in which the hand has taken the target; frames() if none.
std::size_t frame_of_grasp(const Goals& goals, const grasp::HoldTime& when) {
  const auto at = std::ranges::lower_bound(goals.time, when.begin_s);
  return static_cast<std::size_t>(at - goals.time.begin());
}

/// Pads and closed fingers as goals, and the path from which they are sought: where it was, more
/// and more turned to a posture that touches.
void aim_hand(const Approaching& of, const std::vector<std::string>& given_up, Attempt& attempt) {
  const robot::Robot& robot = of.planner.robot;
  Goals& goals = attempt.plan.goals;
  const grasp::HoldTime when = grasp::hold_time(attempt.plan.movement);
  const std::size_t frame = frame_of_grasp(goals, when);
  grasp::aim_pads(robot, attempt.contacts.touches, attempt.plan.movement, of.solid(),
                  of.planner.config.grasp->aperture_m, goals);
  if (frame == goals.frames()) return;
  JointRows& path = attempt.plan.path.position;
  const JointVector before = path.row(static_cast<Eigen::Index>(frame)).transpose();
  map::MappingScratch scratch;
  const JointVector touching = map::solve_frame(as_firm(problem_of(of, attempt), kFirm), frame,
                                                before, of.planner.config.map.solver, scratch)
                                   .x;
  for (std::size_t f = 0; f < goals.frames(); ++f) {
    const double share = grasp::closed_share(when, goals.time[f]);
    if (share == 0) continue;
    path.row(static_cast<Eigen::Index>(f)) += share * (touching - before).transpose();
  }
  if (!of.planner.config.grasp->close_fingers) return;
  std::vector<std::size_t> tips = grasp::tips_without_goals(robot, goals, when);
  std::erase_if(tips, [&](std::size_t tip) {
    return std::ranges::find(given_up, robot.tips[tip].name) != given_up.end();
  });
  const grasp::ClosedFingers closed =
      grasp::close_fingers(of.world, goals.time[frame], tips, touching);
  std::ranges::copy(closed.open, std::back_inserter(attempt.contacts.notes));
  grasp::aim_closings(robot, closed.closings, attempt.plan.movement, of.target, path, goals);
  for (const grasp::Closing& closing : closed.closings) {
    attempt.contacts.touches.push_back(closing.touch);
  }
}

/// The path settled beside where it is. All of it: where the hand shapes late, the wrist begins to
/// turn before.
JointRows settled(const Approaching& of, const Attempt& attempt) {
  const Plan& plan = attempt.plan;
  const grasp::HoldTime when = grasp::hold_time(plan.movement);
  collision::CollisionWorld keeping_off = of.world;
  keeping_off.touch_begin_s = std::max(of.world.touch_begin_s, when.begin_s - kClosing_s);
  map::MapOptions options = of.planner.config.map;
  options.movement.relative_value *= kLessExact;
  const map::MappingProblem problem =
      as_firm(problem_of({of.planner, keeping_off, of.target, of.seed}, attempt), kFirm);
  return map::resolve_between(problem, plan.path, plan.movement.begin_s, plan.movement.end_s,
                              options)
      .position;
}

Attempt try_out(const Approaching& of, const Wanted& wanted, const Plan& by_tips) {
  const PipelineConfig& config = of.planner.config;
  Attempt attempt{by_tips, {wanted.touches, {}}, {}};
  Plan& plan = attempt.plan;
  grasp::keep_outside(of.planner.robot, wanted.kept_outside, plan.movement, of.solid(), plan.goals);
  if (!wanted.touches.empty()) aim_hand(of, wanted.given_up, attempt);
  const map::MappingProblem problem = problem_of(of, attempt);
  plan.path.position = settled(of, attempt);
  const JointRows mapped = plan.path.position;
  const collision::CollisionWorld roomy = with_room(of.world);
  const auto findings_in = [&](const collision::CollisionWorld& world, const JointPath& path) {
    return check::check_path(world, plan.goals, plan.movement, path, config.check);
  };
  const ReSolving solving{problem, config.map,
                          [&](const JointPath& path) { return findings_in(roomy, path); }};
  plan.remaining = findings_in(roomy, plan.path);
  if (!plan.remaining.empty()) {
    Outcome<repair::RepairResult> freed =
        repair::repair_path({repair::if_nearly_free(firmly(solving))}, {plan.path, plan.remaining});
    plan.path = std::move(freed.value.path);
    plan.certificate.repaired = true;
    std::ranges::move(freed.value.steps, std::back_inserter(plan.repair));
    plan.remaining = findings_in(of.world, plan.path);
    if (!plan.remaining.empty()) {
      attempt.refusal = std::move(freed.refusal);
      return attempt;
    }
  }
  map::MapResult judged = map::judge_path(problem, plan.goals, mapped, config.map,
                                          math::seed_from(of.seed, "contacts"));
  plan.mapped = std::move(judged.mapped);
  plan.certificate.natural_posture_error = judged.posture_error_rad;
  return attempt;
}

/// Lets tips that nothing but tracking keeps from their touches touch where their pads are in the
/// grasp; false if there are none. `first`: where they were to touch at first.
bool move_touches(const Approaching& of, const Attempt& attempt,
                  const std::vector<grasp::Touch>& first, Wanted& wanted) {
  const Plan& plan = attempt.plan;
  const robot::Robot& robot = of.planner.robot;
  const std::size_t frame = frame_of_grasp(plan.goals, grasp::hold_time(plan.movement));
  if (frame == plan.goals.frames() || wanted.moves == kMoves) return false;
  if (std::ranges::any_of(plan.remaining, is_collision, &Finding::cause)) return false;
  std::vector<Pose> base_from_frame;
  robot::forward(robot, plan.path.position.row(static_cast<Eigen::Index>(frame)).transpose(),
                 base_from_frame);
  const Pose target_from_base = recorded_pose(of.target, plan.goals.time[frame]).inverse();
  bool any = false;
  for (grasp::Touch& touch : wanted.touches) {
    const std::string& tip = robot.tips[touch.tip].name;
    if (std::ranges::find(plan.remaining, tip, &Finding::first) == plan.remaining.end()) continue;
    const Vec3 pad = robot::goal_point(robot, base_from_frame, touch.tip, 1);
    const grasp::Touch there = grasp::moved_to(robot, of.solid(), target_from_base * pad, touch);
    const auto at_first = std::ranges::find(first, touch.tip, &grasp::Touch::tip);
    if ((there.point - at_first->point).norm() > kFarthestMove_m) continue;
    if (std::ranges::find(wanted.moved, tip) == wanted.moved.end()) wanted.moved.push_back(tip);
    touch = there;
    any = true;
  }
  if (any) ++wanted.moves;
  return any;
}

/// Keeps the goals of tips outside that are in the way though they are not to touch; false if there
/// are no such tips, or they are outside already.
bool keep_more_outside(const robot::Robot& robot, const Attempt& attempt, Wanted& wanted) {
  bool more = false;
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    const auto touches = [&](const grasp::Touch& touch) { return touch.tip == tip; };
    if (std::ranges::any_of(attempt.contacts.touches, touches) ||
        std::ranges::find(wanted.kept_outside, tip) != wanted.kept_outside.end() ||
        !in_the_way(robot, tip, attempt.plan.remaining))
      continue;
    wanted.kept_outside.push_back(tip);
    more = true;
  }
  return more;
}

/// Takes their contacts from tips that are in the way; false if none is.
bool give_up(const robot::Robot& robot, const Attempt& attempt, Wanted& wanted) {
  std::vector<std::string> tips;
  for (const grasp::Touch& touch : attempt.contacts.touches) {
    if (in_the_way(robot, touch.tip, attempt.plan.remaining)) {
      tips.push_back(robot.tips[touch.tip].name);
    }
  }
  std::erase_if(wanted.touches, [&](const grasp::Touch& touch) {
    return std::ranges::find(tips, robot.tips[touch.tip].name) != tips.end();
  });
  std::erase_if(wanted.moved,
                [&](const std::string& tip) { return std::ranges::find(tips, tip) != tips.end(); });
  std::ranges::copy(tips, std::back_inserter(wanted.given_up));
  return !tips.empty();
}

}  // namespace

Contacts wanted_contacts(const Planner& planner, const collision::CollisionWorld& world,
                         const Plan& plan) {
  const grasp::GraspOptions& options = *planner.config.grasp;
  if (world.target < 0) return {};
  if (planner.config.map.mode == map::MapMode::joint_to_joint) {
    return {{}, {"no contact: joint-to-joint mapping does not follow the tips"}};
  }
  const collision::Solid target =
      collision::solid_at(world, static_cast<std::size_t>(world.target));
  Contacts wanted{
      grasp::demonstrated_touches(planner.robot, plan.goals, plan.movement, target, options), {}};
  grasp::make_room(planner.robot, target, world.tolerances.margin, wanted.touches);
  if (wanted.touches.empty()) {
    wanted.notes = {
        fmt::format("no contact: no fingertip's skin was within {:.0f} mm of {} for {:.0f} % "
                    "of the grasp",
                    1e3 * options.near_m, target.object.name, 100 * options.least_share)};
  }
  return wanted;
}

Refusal touch_target(const Planner& planner, const collision::CollisionWorld& world,
                     std::uint64_t seed, Contacts& contacts, Plan& plan) {
  if (world.target < 0) return {};
  const SceneObject& target = plan.scene.objects[static_cast<std::size_t>(world.target)];
  const Approaching of{planner, world, target, seed};
  if (contacts.touches.empty()) {
    plan.remaining =
        check::check_path(world, plan.goals, plan.movement, plan.path, planner.config.check);
    if (plan.remaining.empty()) return {};
  }
  Wanted wanted;
  wanted.touches = contacts.touches;
  const std::vector<grasp::Touch> first = std::move(contacts.touches);
  Refusal why;
  while (true) {
    Attempt attempt = try_out(of, wanted, plan);
    if (!attempt.refusal) {
      std::ranges::move(attempt.contacts.notes, std::back_inserter(contacts.notes));
      if (!wanted.moved.empty()) {
        contacts.notes.push_back(fmt::format("contact of {} moved along {}",
                                             fmt::join(wanted.moved, ", "), target.name));
      }
      if (!wanted.given_up.empty()) {
        contacts.notes.push_back(given_up_sentence(wanted.given_up, why));
      }
      contacts.touches = std::move(attempt.contacts.touches);
      plan = std::move(attempt.plan);
      return {};
    }
    if (!why) why = attempt.refusal;
    if (move_touches(of, attempt, first, wanted)) continue;
    const bool another = keep_more_outside(planner.robot, attempt, wanted) ||
                         give_up(planner.robot, attempt, wanted);
    if (another && (first.empty() || !wanted.touches.empty())) continue;
    contacts = {{}, {given_up_sentence({}, why)}};
    if (!first.empty()) return why;
    plan = std::move(attempt.plan);
    return {attempt.refusal.reason,
            fmt::format("{}; the tips' goals lie deeper in {} than pads and links may sink",
                        attempt.refusal.detail, target.name)};
  }
}

bool in_the_way(const robot::Robot& robot, std::size_t tip, const std::vector<Finding>& findings) {
  const std::string& name = robot.tips[tip].name;
  const int pad = robot.pads[tip].capsule;
  const std::string link = pad < 0 ? "" : robot.capsules[static_cast<std::size_t>(pad)].name;
  return std::ranges::any_of(findings, [&](const Finding& finding) {
    return finding.first == name || (pad >= 0 && (finding.first == link || finding.second == link));
  });
}

std::string given_up_sentence(const std::vector<std::string>& tips, const Refusal& refusal) {
  return fmt::format(
      "{} given up: {}, {}",
      tips.empty() ? "contacts" : fmt::format("contact of {}", fmt::join(tips, ", ")),
      name_of(refusal.reason), refusal.detail);
}

}  // namespace morphe::planning
