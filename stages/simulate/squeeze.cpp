#include "stages/simulate/squeeze.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/collision/distance.hpp"
#include "core/collision/mesh_solid.hpp"
#include "core/robot/forward.hpp"
#include "core/robot/tree.hpp"

namespace morphe::simulate {
namespace {

constexpr int kClosingSteps = 40;
constexpr double kTouching_m = 1e-6, kLargestStep = 0.1;  ///< [rad or m]

std::vector<int> finger_joints(const robot::Robot& robot, std::size_t tip) {
  std::vector<int> joints;
  for (int j = 0; j < static_cast<int>(robot.joints()); ++j) {
    if (robot::moves(robot, j, robot.tips[tip].frame) &&
        std::ranges::count(robot.arm_joints, j) == 0)
      joints.push_back(j);
  }
  return joints;
}

/// Capsules that are rigid with a tip.
std::vector<std::size_t> tip_capsules(const RobotTable& robot, std::size_t tip) {
  const int body = robot::body_of(robot, robot.tips[tip].frame);
  std::vector<std::size_t> capsules;
  for (std::size_t k = 0; k < robot.capsules.size(); ++k) {
    if (robot::body_of(robot, robot.capsules[k].frame) == body) capsules.push_back(k);
  }
  return capsules;
}

struct Nearest {
  std::size_t capsule = 0;
  collision::Separation separation;
};

/// What closing and pressing look at.
struct Hand {
  const robot::Robot& robot;
  const Pose& base_from_target;
  const SceneObject& target;
  std::shared_ptr<const collision::MeshSolid> mesh;
  std::vector<Pose> base_from_frame;

  Nearest nearest(std::size_t tip) const {
    Nearest nearest;
    nearest.separation.distance = kInfinity;
    for (const std::size_t k : tip_capsules(robot, tip)) {
      const RobotTable::Capsule& capsule = robot.capsules[k];
      const Pose& pose = base_from_frame[static_cast<std::size_t>(capsule.frame)];
      const collision::Separation separation =
          collision::capsule_solid({pose * capsule.from, pose * capsule.to, capsule.radius},
                                   {target, mesh.get()}, base_from_target);
      if (separation.distance < nearest.separation.distance) nearest = {k, separation};
    }
    return nearest;
  }

  /// Along a direction in the base frame, of a point that moves with a frame, by some joints.
  JointVector slope(int frame, const Vec3& point, const Vec3& direction,
                    const std::vector<int>& joints) const {
    JointVector all = JointVector::Zero(static_cast<Eigen::Index>(robot.joints()));
    robot::add_point_slope(robot, base_from_frame, frame, -1, point, direction, all);
    JointVector some = JointVector::Zero(all.size());
    for (const int j : joints) some[j] = all[j];
    return some;
  }
};

/// Turns a finger's joints along the steepest descent of its tip's distance until it touches.
void close_finger(Hand& hand, std::size_t tip, JointVector& q) {
  const std::vector<int> joints = finger_joints(hand.robot, tip);
  for (int step = 0; step < kClosingSteps; ++step) {
    robot::forward(hand.robot, q, hand.base_from_frame);
    const auto [capsule, separation] = hand.nearest(tip);
    if (!(std::abs(separation.distance) > kTouching_m)) return;
    const JointVector slope = hand.slope(hand.robot.capsules[capsule].frame, separation.on_first,
                                         separation.normal, joints);
    const double steepness = slope.squaredNorm();
    if (steepness < 1e-8) return;
    const JointVector turn = -separation.distance / steepness * slope;
    const double scale = std::min(1.0, kLargestStep / turn.cwiseAbs().maxCoeff());
    q = (q + scale * turn).cwiseMax(hand.robot.lower).cwiseMin(hand.robot.upper);
  }
}

Hand hand_of(const robot::Robot& robot, const Pose& base_from_target, const SceneObject& target) {
  return {robot, base_from_target, target, collision::mesh_solid_of(target), {}};
}

/// How far beyond where they touch servos must aim for the joints' torques, as far as motors go.
void aim(const robot::Robot& robot, const std::vector<Servo>& servos, const JointVector& torque,
         Squeeze& squeeze) {
  const std::vector<int> motors = motor_frames(robot);
  squeeze.beyond = JointVector::Zero(torque.size());
  for (Eigen::Index j = 0; j < torque.size(); ++j) {
    const Servo& servo = servos[static_cast<std::size_t>(j)];
    const double ratio =
        robot.frames[static_cast<std::size_t>(motors[static_cast<std::size_t>(j)])].ratio;
    if (torque[j] == 0) continue;
    squeeze.force_share =
        std::min(squeeze.force_share, servo.torque * std::abs(ratio) / std::abs(torque[j]));
    squeeze.beyond[j] = torque[j] / (servo.stiffness * ratio * ratio);
  }
  squeeze.beyond *= squeeze.force_share;
}

}  // namespace

Squeeze squeeze_with(const robot::Robot& robot, const JointVector& posture,
                     const Pose& base_from_target, const SceneObject& target,
                     std::vector<Press> presses, const std::vector<Servo>& servos) {
  Squeeze squeeze;
  squeeze.closed = posture;
  Hand hand = hand_of(robot, base_from_target, target);
  for (const Press& press : presses) close_finger(hand, press.tip, squeeze.closed);
  robot::forward(robot, squeeze.closed, hand.base_from_frame);
  JointVector torque = JointVector::Zero(posture.size());
  for (const Press& press : presses) {
    torque += hand.slope(robot.tips[press.tip].frame, base_from_target * press.point,
                         base_from_target.linear() * (press.force_N * press.inward + press.aside),
                         finger_joints(robot, press.tip));
  }
  aim(robot, servos, torque, squeeze);
  squeeze.presses = std::move(presses);
  return squeeze;
}

namespace {

/// The contacts that the plan names, with their forces.
std::vector<Press> stored_presses(const robot::Robot& robot, const Plan& plan) {
  std::vector<Press> presses;
  for (const PadContact& contact : plan.grasp.contacts) {
    const auto tip = std::ranges::find(robot.tips, contact.tip, &RobotTable::Tip::name);
    if (tip == robot.tips.end() || !(contact.force > 0) || !seen(contact.point) ||
        !seen(contact.normal))
      continue;
    presses.push_back({static_cast<std::size_t>(tip - robot.tips.begin()), contact.point,
                       contact.normal, contact.force,
                       seen(contact.friction) ? contact.friction : Vec3(Vec3::Zero())});
  }
  return presses;
}

}  // namespace

std::optional<Squeeze> planned_squeeze(const robot::Robot& robot, const Plan& plan,
                                       const JointVector& posture,
                                       const std::vector<Servo>& servos) {
  const Grasp& grasp = plan.grasp;
  const bool whole =
      grasp.squeeze_torque.size() == posture.size() && grasp.hand_posture.size() == posture.size();
  if (!whole || !grasp.squeeze_torque.allFinite() || !grasp.hand_posture.allFinite())
    return std::nullopt;
  Squeeze squeeze;
  squeeze.planned = true;
  squeeze.presses = stored_presses(robot, plan);
  if (squeeze.presses.size() < 2) return std::nullopt;
  squeeze.closed = posture;
  for (Eigen::Index j = 0; j < posture.size(); ++j) {
    if (std::ranges::count(robot.arm_joints, static_cast<int>(j)) == 0)
      squeeze.closed[j] = grasp.hand_posture[j];
  }
  aim(robot, servos, grasp.squeeze_torque, squeeze);
  return squeeze;
}

std::vector<Press> presses_of(const robot::Robot& robot, const Plan& plan,
                              const JointVector& posture, double force_N, std::string& why_none) {
  const SceneObject& target = *object_named(plan.scene.objects, plan.movement.target);
  const Table<Vec3>& goals = plan.goals.tip_position;
  std::vector<std::size_t> tips;
  bool thumb = false;
  for (std::size_t tip = 0; tip < robot.tips.size() && tip < goals.cols; ++tip) {
    const bool asked = goals.rows > 0 && seen(goals(goals.rows - 1, tip));
    if (!asked || robot.tips[tip].finger < 0 || finger_joints(robot, tip).empty() ||
        tip_capsules(robot, tip).empty())
      continue;
    tips.push_back(tip);
    thumb = thumb || robot.tips[tip].finger == 0;
  }
  if (!thumb || tips.size() < 2) {
    why_none = thumb ? "no finger beside the thumb has a goal and a capsule at its tip"
                     : "no thumb has a goal and a capsule at its tip";
    return {};
  }
  Hand hand = hand_of(robot, plan.grasp.base_from_object, target);
  JointVector closed = posture;
  for (const std::size_t tip : tips) close_finger(hand, tip, closed);
  robot::forward(robot, closed, hand.base_from_frame);
  const Pose target_from_base = plan.grasp.base_from_object.inverse();
  std::vector<Press> presses;
  for (const std::size_t tip : tips) {
    const collision::Separation at = hand.nearest(tip).separation;
    const double share = robot.tips[tip].finger == 0 ? 1 : 1 / static_cast<double>(tips.size() - 1);
    presses.push_back({tip, target_from_base * at.on_second,
                       -(target_from_base.linear() * at.normal), share * force_N});
  }
  return presses;
}

}  // namespace morphe::simulate
