#include "stages/simulate/prepare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/collision/distance.hpp"
#include "core/collision/mesh_solid.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "stages/simulate/plan_lift.hpp"

namespace morphe::simulate {
namespace {

bool is_increasing(const std::vector<double>& time) {
  return std::ranges::adjacent_find(time, [](double a, double b) { return !(a < b); }) ==
         time.end();
}

bool is_valid(const Trajectory& t) {
  return t.samples() >= 2 && t.position.allFinite() && t.velocity.allFinite() &&
         t.acceleration.allFinite() && is_increasing(t.time) && std::isfinite(t.time.front()) &&
         std::isfinite(t.time.back());
}

int target_of(const Plan& plan) {
  for (std::size_t k = 0; k < plan.scene.objects.size(); ++k) {
    if (plan.scene.objects[k].name == plan.movement.target) return static_cast<int>(k);
  }
  return -1;
}

SkipReason initial_skip_reason(const Plan& plan, int target, std::string& detail) {
  if (!plan.has_trajectory()) {
    detail = fmt::format("the plan is infeasible: {}", name_of(plan.reason));
    return SkipReason::infeasible;
  }
  if (target < 0 || plan.grasp.sample < 0) {
    detail = "the plan grasps nothing";
    return SkipReason::no_grasp;
  }
  if (!is_valid(plan.trajectory) || !plan.grasp.base_from_object.matrix().allFinite()) {
    detail =
        "the trajectory or the target's pose contains values that are not finite, or the time does "
        "not increase";
    return SkipReason::invalid_data;
  }
  return SkipReason::none;
}

/// Returns the world's vertical in the base frame.
Vec3 vertical_in_base(const Plan& plan, std::vector<std::string>& notes) {
  if (plan.reference_frames.base_from_world.matrix().allFinite())
    return plan.reference_frames.base_from_world.linear().col(2).normalized();
  notes.push_back("the plan does not give the world's vertical: the z axis of the base is assumed");
  return Vec3::UnitZ();
}

/// Returns the time of the first sample at which a moving capsule touches the target, or at which
/// the fingers begin to close.
double planned_contact_time(const robot::Robot& robot, const Plan& plan,
                            const SceneObject& target) {
  const auto mesh = collision::mesh_solid_of(target);
  const Trajectory& t = plan.trajectory;
  const std::size_t last = last_tracked_sample(plan);
  std::vector<Pose> base_from_frame;
  for (std::size_t i = 0; i < last; ++i) {
    robot::forward_kinematics(robot, t.position.row(i).transpose(), base_from_frame);
    for (const RobotModel::Capsule& capsule : robot.capsules) {
      if (capsule.frame < 0) continue;
      const Pose& pose = base_from_frame[capsule.frame];
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

PreparationResult prepare(const robot::Robot& robot, const Plan& plan,
                          const SimulateOptions& options) {
  PreparationResult prepared;
  const int number = target_of(plan);
  prepared.skip_reason = initial_skip_reason(plan, number, prepared.detail);
  if (prepared.skip_reason != SkipReason::none) return prepared;
  const SceneObject& target = plan.scene.objects[number];
  if (target.shape == Shape::mesh && !collision::mesh_solid_of(target)) {
    prepared.skip_reason = SkipReason::invalid_data;
    prepared.detail = "the target's mesh encloses no volume";
    return prepared;
  }
  if (target.shape == Shape::mesh)
    prepared.notes.push_back("the target's mesh is replaced by its convex hull, solid");

  PreparedPlan& ready = prepared.plan;
  ready.robot = &robot;
  ready.base_from_target = plan.grasp.base_from_object;
  ready.world = {&robot,
                 servos_of(robot, options),
                 robot_inertias(robot, options.density),
                 &plan.scene,
                 number,
                 vertical_in_base(plan, prepared.notes)};
  for (std::size_t k = 0; k < plan.scene.objects.size(); ++k) {
    if (static_cast<int>(k) != number && !is_static_obstacle(ready.world, k))
      prepared.notes.push_back(
          fmt::format("{} is not simulated: it moves, or is a mesh", plan.scene.objects[k].name));
  }
  const JointVector open = plan.trajectory.position.row(last_tracked_sample(plan)).transpose();
  std::optional<GraspCommand> squeeze;
  if (options.contacts == ContactSource::planned)
    squeeze = planned_grasp_command(robot, plan, open, ready.world.servos);
  if (!squeeze) {
    const std::vector<FingerForce> finger_forces =
        nearest_finger_forces(robot, plan, open, options.force_N, prepared.detail);
    if (finger_forces.empty()) {
      prepared.skip_reason = SkipReason::no_opposing_fingers;
      return prepared;
    }
    squeeze = make_grasp_command(robot, open, ready.base_from_target, target, finger_forces,
                                 ready.world.servos);
    prepared.notes.push_back(
        options.contacts == ContactSource::nearest
            ? "the plan's squeeze is not used: fingers with goals close and press"
            : "the plan has no squeeze: fingers with goals close and press");
  }
  ready.squeeze = std::move(*squeeze);
  const auto rows = static_cast<Eigen::Index>(std::llround(kLiftTime_s / options.step_s));
  ready.world.lifts_base = robot.arm_joints.empty();
  if (ready.world.lifts_base) prepared.notes.push_back("a hand without an arm: its base is lifted");
  const std::optional<JointRows> lifting =
      ready.world.lifts_base
          ? JointRows(ready.squeeze.closed_posture.transpose().replicate(rows, 1))
          : plan_lift(robot, ready.squeeze.closed_posture, ready.world.up, kLiftHeight_m, rows);
  if (!lifting) {
    prepared.skip_reason = SkipReason::lift_infeasible;
    prepared.detail =
        fmt::format("the arm cannot lift the palm by {:g} mm from the grasp", 1e3 * kLiftHeight_m);
    return prepared;
  }
  ready.program =
      make_servo_commands(robot, plan, ready.world.servos, ready.squeeze, *lifting, options.step_s);
  ready.planned_contact_s = planned_contact_time(robot, plan, target);
  return prepared;
}

}  // namespace morphe::simulate
