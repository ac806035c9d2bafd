#include "stages/simulate/grasp_command.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/collision/distance.hpp"
#include "core/collision/mesh_solid.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"

namespace morphe::simulate {
namespace {

constexpr int kMaxClosingIterations = 40;
constexpr double kTouchTolerance_m = 1e-6, kMaxJointStep = 0.1;  ///< [rad or m]

std::vector<int> finger_joints(const robot::Robot& robot, int tip) {
  std::vector<int> joints;
  for (int j = 0; j < std::ssize(robot.joint_names); ++j)
    if (robot::joint_moves_frame(robot, j, robot.tips[tip].frame) &&
        std::ranges::count(robot.arm_joints, j) == 0)
      joints.push_back(j);
  return joints;
}
std::vector<int> tip_capsules(const RobotModel& robot, int tip) {
  const int body = robot::moving_frame_of(robot, robot.tips[tip].frame);
  std::vector<int> capsules;
  for (int k = 0; k < std::ssize(robot.capsules); ++k)
    if (robot::moving_frame_of(robot, robot.capsules[k].frame) == body) capsules.push_back(k);
  return capsules;
}

struct NearestCapsule {
  int capsule = 0;
  collision::Separation separation;
};
struct ClosingState {
  const robot::Robot& robot;
  const Pose& base_from_target;
  const SceneObject& target;
  std::shared_ptr<const collision::MeshSolid> mesh;
  std::vector<Pose> base_from_frame;

  NearestCapsule nearest(int tip) const {
    NearestCapsule nearest;
    nearest.separation.distance = kInfinity;
    for (const int k : tip_capsules(robot, tip)) {
      const RobotModel::Capsule& capsule = robot.capsules[k];
      const Pose& pose = base_from_frame[capsule.frame];
      const collision::Separation separation =
          collision::capsule_solid({pose * capsule.from, pose * capsule.to, capsule.radius},
                                   {target, mesh.get()}, base_from_target);
      if (separation.distance < nearest.separation.distance) nearest = {k, separation};
    }
    return nearest;
  }

  /// Returns the gradient of a point's coordinate along `direction`, both in the base frame, for a
  /// point fixed to `frame`; zero but for `joints`.
  JointVector joint_gradient(int frame, const Vec3& point, const Vec3& direction,
                             const std::vector<int>& joints) const {
    JointVector full = JointVector::Zero(robot.joints());
    robot::add_point_gradient(robot, base_from_frame, frame, -1, point, direction, full);
    JointVector gradient = JointVector::Zero(full.size());
    for (const int j : joints) gradient[j] = full[j];
    return gradient;
  }
};

/// Moves a finger's joints along the steepest descent of its tip's distance until it touches.
void close_finger(ClosingState& hand, int tip, JointVector& q) {
  const std::vector<int> joints = finger_joints(hand.robot, tip);
  for (int step = 0; step < kMaxClosingIterations; ++step) {
    robot::forward_kinematics(hand.robot, q, hand.base_from_frame);
    const auto [capsule, separation] = hand.nearest(tip);
    if (!(std::abs(separation.distance) > kTouchTolerance_m)) return;
    const JointVector slope = hand.joint_gradient(hand.robot.capsules[capsule].frame,
                                                  separation.on_first, separation.normal, joints);
    const double steepness = slope.squaredNorm();
    if (steepness < 1e-8) return;
    const JointVector change = -separation.distance / steepness * slope;
    const double scale = std::min(1.0, kMaxJointStep / change.cwiseAbs().maxCoeff());
    q = (q + scale * change).cwiseMax(hand.robot.lower).cwiseMin(hand.robot.upper);
  }
}

ClosingState make_closing_state(const robot::Robot& robot, const Pose& base_from_target,
                                const SceneObject& target) {
  return {robot, base_from_target, target, collision::mesh_solid_of(target), {}};
}

/// Sets the offsets of the servo targets that produce the joint torques, and the scale at which all
/// of them are within motor limits.
void set_servo_offsets(const robot::Robot& robot, const std::vector<Servo>& servos,
                       const JointVector& torque, GraspCommand& squeeze) {
  const std::vector<int> motors = motor_frames(robot);
  squeeze.servo_offset = JointVector::Zero(torque.size());
  for (int j = 0; j < torque.size(); ++j) {
    const Servo& servo = servos[j];
    const double ratio = robot.frames[motors[j]].ratio;
    if (torque[j] == 0) continue;
    squeeze.force_scale =
        std::min(squeeze.force_scale, servo.torque_limit * std::abs(ratio) / std::abs(torque[j]));
    squeeze.servo_offset[j] = torque[j] / (servo.stiffness * ratio * ratio);
  }
  squeeze.servo_offset *= squeeze.force_scale;
}
std::vector<FingerForce> planned_finger_forces(const robot::Robot& robot, const Plan& plan) {
  std::vector<FingerForce> finger_forces;
  for (const PadContact& contact : plan.grasp.contacts) {
    if (!(contact.normal_force > 0) || !is_known(contact.point) || !is_known(contact.normal))
      continue;
    for (int tip = 0; tip < std::ssize(robot.tips); ++tip) {
      if (robot.tips[tip].name != contact.tip) continue;
      finger_forces.push_back(
          {tip, contact.point, contact.normal, contact.normal_force,
           is_known(contact.friction_force) ? contact.friction_force : Vec3(Vec3::Zero())});
      break;
    }
  }
  return finger_forces;
}

}  // namespace

GraspCommand make_grasp_command(const robot::Robot& robot, const JointVector& posture,
                                const Pose& base_from_target, const SceneObject& target,
                                std::vector<FingerForce> finger_forces,
                                const std::vector<Servo>& servos) {
  GraspCommand squeeze;
  squeeze.closed_posture = posture;
  ClosingState hand = make_closing_state(robot, base_from_target, target);
  for (const FingerForce& finger : finger_forces)
    close_finger(hand, finger.tip, squeeze.closed_posture);
  robot::forward_kinematics(robot, squeeze.closed_posture, hand.base_from_frame);
  JointVector torque = JointVector::Zero(posture.size());
  for (const FingerForce& finger : finger_forces) {
    torque += hand.joint_gradient(
        robot.tips[finger.tip].frame, base_from_target * finger.point,
        base_from_target.linear() * (finger.force_N * finger.normal + finger.friction_force_N),
        finger_joints(robot, finger.tip));
  }
  set_servo_offsets(robot, servos, torque, squeeze);
  squeeze.finger_forces = std::move(finger_forces);
  return squeeze;
}

std::optional<GraspCommand> planned_grasp_command(const robot::Robot& robot, const Plan& plan,
                                                  const JointVector& posture,
                                                  const std::vector<Servo>& servos) {
  const JointVector &torque = plan.grasp.grasp_torque, &closed = plan.grasp.grasp_posture;
  if (torque.size() != posture.size() || closed.size() != posture.size() || !torque.allFinite() ||
      !closed.allFinite())
    return std::nullopt;
  GraspCommand squeeze;
  squeeze.is_planned = true;
  squeeze.finger_forces = planned_finger_forces(robot, plan);
  if (squeeze.finger_forces.size() < 2) return std::nullopt;
  squeeze.closed_posture = posture;
  for (int j = 0; j < posture.size(); ++j)
    if (std::ranges::count(robot.arm_joints, j) == 0) squeeze.closed_posture[j] = closed[j];
  set_servo_offsets(robot, servos, torque, squeeze);
  return squeeze;
}

std::vector<FingerForce> nearest_finger_forces(const robot::Robot& robot, const Plan& plan,
                                               const JointVector& posture, double force_N,
                                               std::string& reason) {
  const SceneObject& target = *find_object(plan.scene.objects, plan.movement.target);
  const Array2D<Vec3>& goals = plan.goals.tip_position;
  const std::ptrdiff_t tip_count = std::min(robot.tips.size(), goals.cols);
  std::vector<int> tips;
  bool has_thumb = false;
  for (int tip = 0; tip < tip_count; ++tip) {
    const bool has_goal = goals.rows > 0 && is_known(goals(goals.rows - 1, tip));
    if (!has_goal || robot.tips[tip].finger < 0 || finger_joints(robot, tip).empty() ||
        tip_capsules(robot, tip).empty())
      continue;
    tips.push_back(tip);
    has_thumb = has_thumb || robot.tips[tip].finger == 0;
  }
  if (!has_thumb || tips.size() < 2) {
    reason = has_thumb ? "no finger but the thumb has a goal and a capsule at its tip"
                       : "the thumb has no goal, or no capsule at its tip";
    return {};
  }
  ClosingState hand = make_closing_state(robot, plan.grasp.base_from_object, target);
  JointVector closed = posture;
  for (const int tip : tips) close_finger(hand, tip, closed);
  robot::forward_kinematics(robot, closed, hand.base_from_frame);
  const Pose target_from_base = plan.grasp.base_from_object.inverse();
  std::vector<FingerForce> finger_forces;
  for (const int tip : tips) {
    const collision::Separation nearest = hand.nearest(tip).separation;
    const double share = robot.tips[tip].finger == 0 ? 1 : 1 / static_cast<double>(tips.size() - 1);
    finger_forces.push_back({tip, target_from_base * nearest.on_second,
                             -(target_from_base.linear() * nearest.normal), share * force_N});
  }
  return finger_forces;
}

}  // namespace morphe::simulate
