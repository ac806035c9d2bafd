#include "stages/simulate/prepare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/collision/distance.hpp"
#include "core/collision/mesh_solid.hpp"
#include "core/robot/forward.hpp"
#include "stages/simulate/lift.hpp"

namespace morphe::simulate {
namespace {

bool increasing(const std::vector<double>& time) {
  return std::ranges::adjacent_find(time, [](double a, double b) { return !(a < b); }) ==
         time.end();
}

bool sound(const Trajectory& t) {
  return t.samples() >= 2 && t.position.allFinite() && t.velocity.allFinite() &&
         t.acceleration.allFinite() && increasing(t.time) && std::isfinite(t.time.front()) &&
         std::isfinite(t.time.back());
}

int target_of(const Plan& plan) {
  for (std::size_t k = 0; k < plan.scene.objects.size(); ++k) {
    if (plan.scene.objects[k].name == plan.movement.target) return static_cast<int>(k);
  }
  return -1;
}

Unfit unfit_from_the_start(const Plan& plan, int target, std::string& detail) {
  if (!plan.has_trajectory()) {
    detail = fmt::format("the plan is infeasible: {}", name_of(plan.reason));
    return Unfit::infeasible;
  }
  if (target < 0 || plan.grasp.sample < 0) {
    detail = "nothing is grasped in it";
    return Unfit::no_grasp;
  }
  if (!sound(plan.trajectory) || !plan.grasp.base_from_object.matrix().allFinite()) {
    detail =
        "its trajectory or the target's pose holds numbers that are none, or time stands still";
    return Unfit::broken;
  }
  return Unfit::none;
}

/// The world's vertical as the base sees it.
Vec3 upwards_of(const Plan& plan, std::vector<std::string>& notes) {
  if (plan.world.base_from_world.matrix().allFinite())
    return plan.world.base_from_world.linear().col(2).normalized();
  notes.push_back("the plan does not say where the world's vertical is: the base's z is taken");
  return Vec3::UnitZ();
}

/// The first sample in which a capsule that moves touches the target, or where the fingers begin to
/// close.
double planned_contact(const robot::Robot& robot, const Plan& plan, const SceneObject& target) {
  const auto mesh = collision::mesh_solid_of(target);
  const Trajectory& t = plan.trajectory;
  const std::size_t last = last_followed(plan);
  std::vector<Pose> base_from_frame;
  for (std::size_t i = 0; i < last; ++i) {
    robot::forward(robot, t.position.row(static_cast<Eigen::Index>(i)).transpose(),
                   base_from_frame);
    for (const RobotTable::Capsule& capsule : robot.capsules) {
      if (capsule.frame < 0) continue;
      const Pose& pose = base_from_frame[static_cast<std::size_t>(capsule.frame)];
      const collision::CapsuleBody body{pose * capsule.from, pose * capsule.to, capsule.radius};
      const double reach = 0.5 * (body.to - body.from).norm() + body.radius +
                           collision::bounding_radius({target, mesh.get()});
      const Vec3 apart = 0.5 * (body.from + body.to) - plan.grasp.base_from_object.translation();
      if (apart.norm() > reach) continue;
      if (collision::capsule_solid(body, {target, mesh.get()}, plan.grasp.base_from_object)
              .distance <= 0)
        return t.time[i] - t.time.front();
    }
  }
  return t.time[last] - t.time.front();
}

}  // namespace

Prepared prepare(const robot::Robot& robot, const Plan& plan, const SimulateOptions& options) {
  Prepared prepared;
  const int number = target_of(plan);
  prepared.unfit = unfit_from_the_start(plan, number, prepared.detail);
  if (prepared.unfit != Unfit::none) return prepared;
  const SceneObject& target = plan.scene.objects[static_cast<std::size_t>(number)];
  if (target.shape == Shape::mesh && !collision::mesh_solid_of(target)) {
    prepared.unfit = Unfit::broken;
    prepared.detail = "the target's mesh has no inside";
    return prepared;
  }
  if (target.shape == Shape::mesh)
    prepared.notes.push_back("the target's mesh counts as its convex hull, solid");

  PreparedPlan& ready = prepared.plan;
  ready.robot = &robot;
  ready.base_from_target = plan.grasp.base_from_object;
  ready.world = {
      &robot, servos_of(robot, options),       robot_inertias(robot, options.density), &plan.scene,
      number, upwards_of(plan, prepared.notes)};
  for (std::size_t k = 0; k < plan.scene.objects.size(); ++k) {
    if (static_cast<int>(k) != number && !stands_around(ready.world, k))
      prepared.notes.push_back(
          fmt::format("{} is left out: it moves, or is a mesh", plan.scene.objects[k].name));
  }
  const JointVector open =
      plan.trajectory.position.row(static_cast<Eigen::Index>(last_followed(plan))).transpose();
  std::optional<Squeeze> squeeze;
  if (options.contacts == Contacts::stored)
    squeeze = planned_squeeze(robot, plan, open, ready.world.servos);
  if (!squeeze) {
    const std::vector<Press> presses =
        presses_of(robot, plan, open, options.force_N, prepared.detail);
    if (presses.empty()) {
      prepared.unfit = Unfit::no_squeeze;
      return prepared;
    }
    squeeze =
        squeeze_with(robot, open, ready.base_from_target, target, presses, ready.world.servos);
    prepared.notes.push_back(options.contacts == Contacts::nearest
                                 ? "not the plan's squeeze: fingers with goals close and press"
                                 : "the plan has no squeeze: fingers with goals close and press");
  }
  ready.squeeze = std::move(*squeeze);
  const auto rows = static_cast<Eigen::Index>(std::llround(kLift_s / options.step_s));
  ready.world.lifts_base = robot.arm_joints.empty();
  if (ready.world.lifts_base) prepared.notes.push_back("a hand without an arm: its base is lifted");
  const std::optional<JointRows> lifting =
      ready.world.lifts_base ? JointRows(ready.squeeze.closed.transpose().replicate(rows, 1))
                             : lift(robot, ready.squeeze.closed, ready.world.up, kLift_m, rows);
  if (!lifting) {
    prepared.unfit = Unfit::no_lift;
    prepared.detail = fmt::format("the arm cannot lift the palm by {:g} m from the grasp", kLift_m);
    return prepared;
  }
  ready.program =
      program_of(robot, plan, ready.world.servos, ready.squeeze, *lifting, options.step_s);
  ready.planned_contact_s = planned_contact(robot, plan, target);
  return prepared;
}

}  // namespace morphe::simulate
