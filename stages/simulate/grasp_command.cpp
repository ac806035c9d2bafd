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

std::vector<int> finger_joints(const robot::Robot& robot, std::size_t tip) {
  std::vector<int> joints;
  for (int j = 0; j < static_cast<int>(robot.joints()); ++j) {
    if (robot::joint_moves_frame(robot, j, robot.tips[tip].frame) &&
        std::ranges::count(robot.arm_joints, j) == 0)
      joints.push_back(j);
  }
  return joints;
}

/// Returns the capsules that are rigidly connected to a tip.
std::vector<std::size_t> tip_capsules(const RobotModel& robot, std::size_t tip) {
  const int body = robot::moving_frame_of(robot, robot.tips[tip].frame);
  std::vector<std::size_t> capsules;
  for (std::size_t k = 0; k < robot.capsules.size(); ++k) {
    if (robot::moving_frame_of(robot, robot.capsules[k].frame) == body) capsules.push_back(k);
  }
  return capsules;
}

struct NearestCapsule {
  std::size_t capsule = 0;
  collision::Separation separation;
};

/// The geometry used for closing and pressing.
struct ClosingState {
  const robot::Robot& robot;
  const Pose& base_from_target;
  const SceneObject& target;
  std::shared_ptr<const collision::MeshSolid> mesh;
  std::vector<Pose> base_from_frame;

  NearestCapsule nearest(std::size_t tip) const {
    NearestCapsule nearest;
    nearest.separation.distance = kInfinity;
    for (const std::size_t k : tip_capsules(robot, tip)) {
      const RobotModel::Capsule& capsule = robot.capsules[k];
      const Pose& pose = base_from_frame[capsule.frame];
      const collision::Separation separation =
          collision::capsule_solid({pose * capsule.from, pose * capsule.to, capsule.radius},
                                   {target, mesh.get()}, base_from_target);
      if (separation.distance < nearest.separation.distance) nearest = {k, separation};
    }
    return nearest;
  }

  /// Returns the gradient, with respect to the given joints, of the motion of a point fixed to a
  /// frame along a direction in the base frame.
  JointVector joint_gradient(int frame, const Vec3& point, const Vec3& direction,
                             const std::vector<int>& joints) const {
    JointVector all = JointVector::Zero(robot.joints());
    robot::add_point_gradient(robot, base_from_frame, frame, -1, point, direction, all);
    JointVector some = JointVector::Zero(all.size());
    for (const int j : joints) some[j] = all[j];
    return some;
  }
};

/// Moves a finger's joints along the steepest descent of its tip's distance until it touches.
void close_finger(ClosingState& hand, std::size_t tip, JointVector& q) {
  const std::vector<int> joints = finger_joints(hand.robot, tip);
  for (int step = 0; step < kMaxClosingIterations; ++step) {
    robot::forward_kinematics(hand.robot, q, hand.base_from_frame);
    const auto [capsule, separation] = hand.nearest(tip);
    if (!(std::abs(separation.distance) > kTouchTolerance_m)) return;
    const JointVector slope = hand.joint_gradient(hand.robot.capsules[capsule].frame,
                                                  separation.on_first, separation.normal, joints);
    const double steepness = slope.squaredNorm();
    if (steepness < 1e-8) return;
    const JointVector turn = -separation.distance / steepness * slope;
    const double scale = std::min(1.0, kMaxJointStep / turn.cwiseAbs().maxCoeff());
    q = (q + scale * turn).cwiseMax(hand.robot.lower).cwiseMin(hand.robot.upper);
  }
}

ClosingState make_closing_state(const robot::Robot& robot, const Pose& base_from_target,
                                const SceneObject& target) {
  return {robot, base_from_target, target, collision::mesh_solid_of(target), {}};
}

/// Computes the offsets of the servo targets from the contact posture that produce the joint
/// torques, within the limits of the motors.
void set_servo_offsets(const robot::Robot& robot, const std::vector<Servo>& servos,
                       const JointVector& torque, GraspCommand& squeeze) {
  const std::vector<int> motors = motor_frames(robot);
  squeeze.servo_offset = JointVector::Zero(torque.size());
  for (Eigen::Index j = 0; j < torque.size(); ++j) {
    const Servo& servo = servos[j];
    const double ratio = robot.frames[motors[j]].ratio;
    if (torque[j] == 0) continue;
    squeeze.force_scale =
        std::min(squeeze.force_scale, servo.torque_limit * std::abs(ratio) / std::abs(torque[j]));
    squeeze.servo_offset[j] = torque[j] / (servo.stiffness * ratio * ratio);
  }
  squeeze.servo_offset *= squeeze.force_scale;
}

}  // namespace

GraspCommand make_grasp_command(const robot::Robot& robot, const JointVector& posture,
                                const Pose& base_from_target, const SceneObject& target,
                                std::vector<FingerForce> finger_forces,
                                const std::vector<Servo>& servos) {
  GraspCommand squeeze;
  squeeze.closed_posture = posture;
  ClosingState hand = make_closing_state(robot, base_from_target, target);
  for (const FingerForce& press : finger_forces)
    close_finger(hand, press.tip, squeeze.closed_posture);
  robot::forward_kinematics(robot, squeeze.closed_posture, hand.base_from_frame);
  JointVector torque = JointVector::Zero(posture.size());
  for (const FingerForce& press : finger_forces) {
    torque += hand.joint_gradient(
        robot.tips[press.tip].frame, base_from_target * press.point,
        base_from_target.linear() * (press.force_N * press.normal + press.friction_force_N),
        finger_joints(robot, press.tip));
  }
  set_servo_offsets(robot, servos, torque, squeeze);
  squeeze.finger_forces = std::move(finger_forces);
  return squeeze;
}

namespace {

/// Returns the contacts of the plan's grasp with their forces.
std::vector<FingerForce> planned_finger_forces(const robot::Robot& robot, const Plan& plan) {
  std::vector<FingerForce> finger_forces;
  for (const PadContact& contact : plan.grasp.contacts) {
    const auto tip = std::ranges::find(robot.tips, contact.tip, &RobotModel::Tip::name);
    if (tip == robot.tips.end() || !(contact.normal_force > 0) || !is_known(contact.point) ||
        !is_known(contact.normal))
      continue;
    finger_forces.push_back(
        {static_cast<std::size_t>(tip - robot.tips.begin()), contact.point, contact.normal,
         contact.normal_force,
         is_known(contact.friction_force) ? contact.friction_force : Vec3(Vec3::Zero())});
  }
  return finger_forces;
}

}  // namespace

std::optional<GraspCommand> planned_grasp_command(const robot::Robot& robot, const Plan& plan,
                                                  const JointVector& posture,
                                                  const std::vector<Servo>& servos) {
  const Grasp& grasp = plan.grasp;
  const bool whole =
      grasp.grasp_torque.size() == posture.size() && grasp.grasp_posture.size() == posture.size();
  if (!whole || !grasp.grasp_torque.allFinite() || !grasp.grasp_posture.allFinite())
    return std::nullopt;
  GraspCommand squeeze;
  squeeze.is_planned = true;
  squeeze.finger_forces = planned_finger_forces(robot, plan);
  if (squeeze.finger_forces.size() < 2) return std::nullopt;
  squeeze.closed_posture = posture;
  for (Eigen::Index j = 0; j < posture.size(); ++j) {
    if (std::ranges::count(robot.arm_joints, static_cast<int>(j)) == 0)
      squeeze.closed_posture[j] = grasp.grasp_posture[j];
  }
  set_servo_offsets(robot, servos, grasp.grasp_torque, squeeze);
  return squeeze;
}

std::vector<FingerForce> nearest_finger_forces(const robot::Robot& robot, const Plan& plan,
                                               const JointVector& posture, double force_N,
                                               std::string& why_none) {
  const SceneObject& target = *find_object(plan.scene.objects, plan.movement.target);
  const Array2D<Vec3>& goals = plan.goals.tip_position;
  std::vector<std::size_t> tips;
  bool thumb = false;
  for (std::size_t tip = 0; tip < robot.tips.size() && tip < goals.cols; ++tip) {
    const bool asked = goals.rows > 0 && is_known(goals(goals.rows - 1, tip));
    if (!asked || robot.tips[tip].finger < 0 || finger_joints(robot, tip).empty() ||
        tip_capsules(robot, tip).empty())
      continue;
    tips.push_back(tip);
    thumb = thumb || robot.tips[tip].finger == 0;
  }
  if (!thumb || tips.size() < 2) {
    why_none = thumb ? "no finger but the thumb has a goal and a capsule at its tip"
                     : "the thumb has no goal, or no capsule at its tip";
    return {};
  }
  ClosingState hand = make_closing_state(robot, plan.grasp.base_from_object, target);
  JointVector closed = posture;
  for (const std::size_t tip : tips) close_finger(hand, tip, closed);
  robot::forward_kinematics(robot, closed, hand.base_from_frame);
  const Pose target_from_base = plan.grasp.base_from_object.inverse();
  std::vector<FingerForce> finger_forces;
  for (const std::size_t tip : tips) {
    const collision::Separation at = hand.nearest(tip).separation;
    const double share = robot.tips[tip].finger == 0 ? 1 : 1 / static_cast<double>(tips.size() - 1);
    finger_forces.push_back({tip, target_from_base * at.on_second,
                             -(target_from_base.linear() * at.normal), share * force_N});
  }
  return finger_forces;
}

}  // namespace morphe::simulate
