#include "stages/simulate/prepare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/collision/distance.hpp"
#include "core/collision/mesh_solid.hpp"
#include "core/motion/assumption_text.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "stages/simulate/plan_lift.hpp"

namespace morphe::simulate {
namespace {

/// Smaller changes of a support's height are not noted.
constexpr double kMinNotedRaise_m = 1e-4;

bool is_increasing(const std::vector<double>& t) {
  return std::ranges::adjacent_find(t, [](double a, double b) { return !(a < b); }) == t.end();
}

bool is_valid(const Trajectory& trajectory) {
  const std::vector<double>& time = trajectory.time;
  return time.size() >= 2 && trajectory.position.allFinite() && trajectory.velocity.allFinite() &&
         trajectory.acceleration.allFinite() && is_increasing(time) &&
         std::isfinite(time.front()) && std::isfinite(time.back());
}

int target_of(const Plan& plan) {
  for (int k = 0; k < std::ssize(plan.scene.objects); ++k)
    if (plan.scene.objects[k].name == plan.movement.target) return k;
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

/// Returns the time since the start of the trajectory at which a capsule first touches the target
/// or, if none does before, at which the fingers begin to close.
double planned_contact_s(const robot::Robot& robot, const Plan& plan, const SceneObject& target) {
  const auto mesh = collision::mesh_solid_of(target);
  const std::vector<double>& time = plan.trajectory.time;
  const Eigen::Index last = last_tracked_sample(plan);
  std::vector<Pose> base_from_frame;
  for (int i = 0; i < last; ++i) {
    robot::forward_kinematics(robot, plan.trajectory.position.row(i).transpose(), base_from_frame);
    for (const RobotModel::Capsule& capsule : robot.capsules) {
      if (capsule.frame < 0) continue;
      const Pose& pose = base_from_frame[capsule.frame];
      const collision::CapsuleBody body{pose * capsule.from, pose * capsule.to, capsule.radius};
      const double max_touch_m = 0.5 * (body.to - body.from).norm() + body.radius +
                                 collision::bounding_radius({target, mesh.get()});
      const Vec3 offset = 0.5 * (body.from + body.to) - plan.grasp.base_from_object.translation();
      if (offset.norm() > max_touch_m) continue;
      if (collision::capsule_solid(body, {target, mesh.get()}, plan.grasp.base_from_object)
              .distance <= 0)
        return time[i] - time.front();
    }
  }
  return time[last] - time.front();
}

/// Returns the time of the simulation at which a trajectory's clock has reached a time.
double simulated_time_s(const ServoCommands& program, double trajectory_s, double step_s) {
  const auto after = std::ranges::find_if(program.trajectory_s,
                                          [&](double t) { return t >= trajectory_s - 1e-9; });
  const auto steps = after - program.trajectory_s.begin();
  return steps == 0 ? trajectory_s : static_cast<double>(steps + 1) * step_s;
}

/// Plans the lift for a plan without a task.
void prepare_lift(const Plan& plan, const SimulateOptions& options, PreparationResult& prepared) {
  PreparedPlan& ready = prepared.plan;
  const robot::Robot& robot = *ready.robot;
  const Eigen::Index rows = std::lround(kLiftTime_s / options.step_s);
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
    return;
  }
  ready.program = lift_commands(plan, ready.world.servos, ready.squeeze, *lifting, options.step_s);
}

/// Puts the target of a plan with a task on the object that supports it, and writes the commands.
void prepare_task(const Plan& plan, const SimulateOptions& options, PreparationResult& prepared) {
  PreparedPlan& ready = prepared.plan;
  SimulatedWorld& world = ready.world;
  std::vector<int> resting;
  for (int k = 0; k < std::ssize(plan.scene.objects); ++k)
    if (is_static_obstacle(world, k)) resting.push_back(k);
  world.support = find_support(plan.scene, world.target, resting, ready.base_from_target, world.up);
  if (!world.support) {
    prepared.notes.push_back(
        "the target stands on no resting object of the scene: an endless plane through its lowest "
        "point supports it, at its planned place too");
  } else {
    for (const Pose& pose : {ready.base_from_target, ready.task->base_from_placed})
      for (const Vec3& foot :
           foot_points(plan.scene.objects[world.target], pose.linear().transpose() * world.up))
        world.feet.push_back(foot);
    if (std::abs(world.support->raise_m) > kMinNotedRaise_m)
      prepared.notes.push_back(fmt::format(
          "{} is raised by {:.1f} mm, to the target's lowest point",
          plan.scene.objects[world.support->object].name, 1e3 * world.support->raise_m));
  }
  if (!ready.task->lets_go)
    prepared.notes.push_back("the plan ends before the hand lets go of the target");
  ready.program =
      task_commands(plan, *ready.task, ready.world.servos, ready.squeeze, options.step_s);
}

}  // namespace

PreparationResult prepare(const robot::Robot& robot, const Plan& plan,
                          const SimulateOptions& options) {
  PreparationResult prepared;
  const int target_index = target_of(plan);
  prepared.skip_reason = initial_skip_reason(plan, target_index, prepared.detail);
  if (prepared.skip_reason != SkipReason::none) return prepared;
  const SceneObject& target = plan.scene.objects[target_index];
  if (target.shape == Shape::mesh && !collision::mesh_solid_of(target)) {
    prepared.skip_reason = SkipReason::invalid_data;
    prepared.detail = "the target's mesh encloses no volume";
    return prepared;
  }
  if (target.shape == Shape::mesh)
    prepared.notes.push_back("the target's mesh is replaced by its convex hull, solid");
  for (const Assumption& each : object_assumptions(plan)) {
    if (each.kind == AssumptionKind::inferred && each.subject == name_of(Knowable::target))
      prepared.notes.push_back("inferred, not recorded: " + each.value);
  }

  PreparedPlan& ready = prepared.plan;
  ready.robot = &robot;
  ready.base_from_target = plan.grasp.base_from_object;
  ready.palm_from_target = plan.grasp.object_from_palm.inverse();
  ready.world = {&robot,
                 servos_of(robot, options),
                 robot_inertias(robot, options.density),
                 &plan.scene,
                 target_index,
                 vertical_in_base(plan, prepared.notes)};
  for (int k = 0; k < std::ssize(plan.scene.objects); ++k) {
    if (k != target_index && !is_static_obstacle(ready.world, k))
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
  ready.task = planned_task(robot, plan, last_tracked_sample(plan), ready.world.up);
  if (ready.task)
    prepare_task(plan, options, prepared);
  else
    prepare_lift(plan, options, prepared);
  if (prepared.skip_reason == SkipReason::none)
    ready.planned_contact_s =
        simulated_time_s(ready.program, planned_contact_s(robot, plan, target), options.step_s);
  return prepared;
}

}  // namespace morphe::simulate
