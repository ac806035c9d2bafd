#include "stages/planning/contacts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "pipeline/collision/mesh_solid.hpp"
#include "pipeline/math/seed.hpp"
#include "stages/check/check_path.hpp"
#include "stages/grasp/close_fingers.hpp"
#include "stages/grasp/demonstrated.hpp"
#include "stages/map/frame_search.hpp"
#include "stages/map/map_movement.hpp"
#include "stages/map/resolve_path.hpp"
#include "stages/planning/firmness.hpp"
#include "stages/planning/re_solve.hpp"
#include "stages/planning/repair_movement.hpp"

namespace morphe::planning {
namespace {

constexpr Firmness kFirm{1000, 0.2};  ///< the path keeps clear as where it is re-solved firmly
constexpr double kLessExact = 10;     ///< it settles beside another: values this much less exact

/// Before its last moments of closing the hand keeps off the target where it can, though touching
/// is allowed from the preshape on: fingers that rub along an object push it over [s].
constexpr double kClosing_s = 0.3;

/// A movement whose tips are about to touch its target.
struct Approaching {
  const Planner& planner;
  const collision::CollisionWorld& world;
  const SceneObject& target;
  std::uint64_t seed;
};

/// A plan with the contacts of some tips, and why it cannot be executed so.
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
  grasp::aim_pads(robot, attempt.contacts.touches, attempt.plan.movement,
                  {of.target, of.world.meshes[static_cast<std::size_t>(of.world.target)].get()},
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

/// The path settled beside where it is, from where the hand begins to shape.
JointRows settled(const Approaching& of, const Attempt& attempt) {
  const Plan& plan = attempt.plan;
  const grasp::HoldTime when = grasp::hold_time(plan.movement);
  collision::CollisionWorld keeping_off = of.world;
  keeping_off.touch_begin_s = std::max(of.world.touch_begin_s, when.begin_s - kClosing_s);
  map::MapOptions options = of.planner.config.map;
  options.movement.relative_value *= kLessExact;
  const map::MappingProblem problem =
      as_firm(problem_of({of.planner, keeping_off, of.target, of.seed}, attempt), kFirm);
  return map::resolve_between(problem, plan.path, when.open_s, plan.movement.end_s, options)
      .position;
}

Attempt touch_with(const Approaching& of, const std::vector<grasp::Touch>& touches,
                   const std::vector<std::string>& given_up, const Plan& by_tips) {
  const PipelineConfig& config = of.planner.config;
  Attempt attempt{by_tips, {touches, {}}, {}};
  Plan& plan = attempt.plan;
  aim_hand(of, given_up, attempt);
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
    Outcome<repair::RepairResult> freed = repair::repair_path(
        {repair::if_nearly_free(firmly(solving))}, {plan.path, plan.remaining}, config.repair);
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

}  // namespace

Tolerances with_contacts(const PipelineConfig& config) {
  Tolerances tolerances = config.check.tolerances;
  tolerances.contact_depth = config.grasp->penetration_m;
  return tolerances;
}

Contacts touch_target(const Planner& planner, const collision::CollisionWorld& world,
                      std::uint64_t seed, Plan& plan) {
  const grasp::GraspOptions& options = *planner.config.grasp;
  const SceneObject* target = object_named(plan.scene.objects, plan.movement.target);
  if (!target) return {};
  if (planner.config.map.mode == map::MapMode::joint_to_joint) {
    return {{}, {"no contact: joint-to-joint mapping does not follow the tips"}};
  }
  const auto mesh = collision::mesh_solid_of(*target, planner.config.scene.meshes);
  std::vector<grasp::Touch> touches = grasp::demonstrated_touches(
      planner.robot, plan.goals, plan.movement, {*target, mesh.get()}, options);
  if (touches.empty()) {
    return {{},
            {fmt::format("no contact: no fingertip's skin was within {:.0f} mm of {} for {:.0f} % "
                         "of the grasp",
                         1e3 * options.near_m, target->name, 100 * options.least_share)}};
  }
  grasp::make_room(planner.robot, {*target, mesh.get()}, world.tolerances.margin, touches);
  const Approaching of{planner, world, *target, seed};
  Attempt first = touch_with(of, touches, {}, plan);
  if (!first.refusal) {
    plan = std::move(first.plan);
    return std::move(first.contacts);
  }
  const std::vector<std::string> tips =
      tips_in_the_way(planner.robot, first.plan.goals, first.plan.remaining);
  std::erase_if(touches, [&](const grasp::Touch& touch) {
    return std::ranges::find(tips, planner.robot.tips[touch.tip].name) != tips.end();
  });
  if (!tips.empty() && !touches.empty()) {
    Attempt second = touch_with(of, touches, tips, plan);
    if (!second.refusal) {
      plan = std::move(second.plan);
      second.contacts.notes.push_back(given_up_sentence(tips, first.refusal));
      return std::move(second.contacts);
    }
  }
  return {{}, {given_up_sentence({}, first.refusal)}};
}

std::vector<std::string> tips_in_the_way(const robot::Robot& robot, const Goals& goals,
                                         const std::vector<Finding>& findings) {
  std::vector<std::string> tips;
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    bool touches = false;
    for (std::size_t f = 0; f < goals.frames(); ++f) {
      touches = touches || goals.pad_share(f, tip) > 0;
    }
    if (!touches) continue;
    const std::string &name = robot.tips[tip].name,
                      &link =
                          robot.capsules[static_cast<std::size_t>(robot.pads[tip].capsule)].name;
    const bool concerned = std::ranges::any_of(findings, [&](const Finding& finding) {
      return finding.first == name || finding.first == link || finding.second == link;
    });
    if (concerned) tips.push_back(name);
  }
  return tips;
}

std::string given_up_sentence(const std::vector<std::string>& tips, const Refusal& refusal) {
  return fmt::format(
      "{} given up: {}, {}",
      tips.empty() ? "contacts" : fmt::format("contact of {}", fmt::join(tips, ", ")),
      name_of(refusal.reason), refusal.detail);
}

}  // namespace morphe::planning
