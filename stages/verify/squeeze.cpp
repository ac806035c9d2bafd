#include "stages/verify/squeeze.hpp"

#include <algorithm>
#include <cmath>

#include "stages/verify/finger_levers.hpp"
#include "stages/verify/grasp_quality.hpp"
#include "stages/verify/pressing.hpp"
#include "stages/verify/stated_grasp.hpp"

namespace morphe::verify {
namespace {

constexpr double kAgreeing = 1e-6;
constexpr double kUnbalanced = 0.03, kLeast_N = 2e-3;
constexpr double kClosed = 1e-3;  ///< epsilon as near as it is known

/// The wrench of all forces, and the moments about the normals that could take part of it.
struct Balance {
  Vector6 wrench = Vector6::Zero();
  std::vector<Vec3> ways;     ///< of moments over the torque scale, as long as they can be [N]
  std::vector<double> share;  ///< -1 to 1 of each
  double largest = 0;

  /// What moments cannot take: a convex problem, by one moment after the other.
  double left() {
    share.assign(ways.size(), 0);
    Vec3 torque = wrench.tail<3>();
    for (int round = 0; round < 1000; ++round) {
      for (std::size_t k = 0; k < ways.size(); ++k) {
        const double length = ways[k].squaredNorm();
        if (!(length > 0)) continue;
        const Vec3 others = torque - share[k] * ways[k];
        share[k] = std::clamp(-others.dot(ways[k]) / length, -1.0, 1.0);
        torque = others + share[k] * ways[k];
      }
    }
    return std::hypot(wrench.head<3>().norm(), torque.norm());
  }
};

/// Adds a contact's force, and says how far that is outside of its cone [N].
double add_force(const PadContact& contact, const GraspQuality& quality, Balance& sum) {
  const Vec3 lever = (contact.point - quality.centre) / quality.torque_scale;
  const Vec3 force = contact.force * contact.normal + contact.friction;
  sum.wrench.head<3>() += force;
  sum.wrench.tail<3>() += lever.cross(force);
  sum.largest = std::max(sum.largest, contact.force);
  const double most = quality.friction * contact.force, used = contact.friction.norm();
  const double share = most > 0 ? std::min(1.0, used / most) : 1;
  sum.ways.push_back(quality.torsion * contact.force * std::sqrt(1 - share * share) /
                     quality.torque_scale * contact.normal);
  return std::max(used - most, std::abs(contact.friction.dot(contact.normal)));
}

void judge_torques(const Grasp& grasp, const JointVector& expected, const std::string& config,
                   ViolationRuns& runs) {
  const JointVector& torque = grasp.squeeze_torque;
  const double off = (torque - expected).cwiseAbs().maxCoeff();
  if (!(off <= kAgreeing)) runs.note_plan("squeeze", "torque", off, kAgreeing);
  const double most = stated_for_grasp(config, "joint_torque").value_or(kInfinity);
  const double largest = torque.cwiseAbs().maxCoeff();
  if (!(largest <= most * (1 + kAgreeing))) runs.note_plan("squeeze", "torque", largest, most);

  const JointVector turned = grasp.squeeze_posture - grasp.hand_posture;
  const double fitting = torque.squaredNorm() / torque.dot(turned);
  const double stiffness = stated_for_grasp(config, "joint_stiffness").value_or(fitting);
  const double beside = torque.isZero(0) ? turned.cwiseAbs().maxCoeff()
                                         : (turned - torque / stiffness).cwiseAbs().maxCoeff();
  if (!(beside <= kAgreeing)) runs.note_plan("squeeze", "servo_target", beside, kAgreeing);
}

/// The squeeze is beside the trajectory, never in it.
void judge_apart(const Plan& plan, ViolationRuns& runs) {
  const JointVector& target = plan.grasp.squeeze_posture;
  if ((target - plan.grasp.hand_posture).cwiseAbs().maxCoeff() <= kAgreeing) return;
  for (Eigen::Index k = plan.grasp.sample; k < plan.trajectory.position.rows(); ++k) {
    double off = 0;
    for (Eigen::Index joint = 0; joint < target.size(); ++joint) {
      if (plan.grasp.squeeze_torque[joint] == 0) continue;
      off = std::max(off, std::abs(plan.trajectory.position(k, joint) - target[joint]));
    }
    if (off > kAgreeing) continue;
    runs.note_plan("squeeze", "trajectory", off, kAgreeing);
    return;
  }
}

}  // namespace

void judge_squeeze(const RobotTable& robot, const Plan& plan, const std::string& config,
                   ViolationRuns& runs) {
  const Grasp& grasp = plan.grasp;
  const std::vector<std::size_t> touching = contacts_that_touch(grasp);
  const auto note = [&](const std::string& subject, double value, double limit) {
    runs.note_plan("squeeze", subject, value, limit);
  };
  for (std::size_t k = 0; k < grasp.contacts.size(); ++k) {
    const PadContact& contact = grasp.contacts[k];
    const bool presses = touching.size() >= 2 && std::ranges::find(touching, k) != touching.end();
    if (!presses && !(std::isnan(contact.force) && contact.friction.array().isNaN().all()))
      note(contact.tip + "/force", contact.force, kNotSeen);
  }
  const auto joints = static_cast<Eigen::Index>(robot.joints());
  const bool there =
      grasp.squeeze_torque.size() == joints && grasp.squeeze_posture.size() == joints;
  if (touching.size() < 2) {
    if (grasp.squeeze_torque.size() > 0) note("torque", kNotSeen, kNotSeen);
    return;
  }
  if (!there) {
    // Forces that hold an object in balance exist where the signed epsilon is above 0.
    if (grasp.quality.epsilon_lower > kClosed) note("torque", kNotSeen, kNotSeen);
    return;
  }
  if (!grasp.squeeze_torque.allFinite() || !grasp.squeeze_posture.allFinite())
    return runs.note_plan("finite", "grasp/squeeze", kNotSeen, kNotSeen);

  const SceneObject& target = *object_named(plan.scene.objects, plan.movement.target);
  const Pose base_from_object = recorded_pose(
      target, plan.trajectory.demonstration_time[static_cast<std::size_t>(grasp.sample)]);
  const double most = stated_for_grasp(config, "squeeze_force").value_or(kInfinity);
  Balance sum;
  JointVector torque = JointVector::Zero(joints);
  for (const std::size_t row : touching) {
    const PadContact& contact = grasp.contacts[row];
    if (!(contact.force >= 0 && contact.force <= most * (1 + kAgreeing)))
      note(contact.tip + "/force", contact.force, contact.force > most ? most : 0);
    const double outside = add_force(contact, grasp.quality, sum);
    const double rounding = kAgreeing * std::max(1.0, contact.force);
    if (!(outside <= rounding)) note(contact.tip + "/cone", outside, rounding);
    const auto tip = std::ranges::find(robot.tips, contact.tip, &RobotTable::Tip::name);
    const Vec3 force =
        base_from_object.linear() * (contact.force * contact.normal + contact.friction);
    torque += finger_levers(robot, grasp.hand_posture, tip->frame, base_from_object * contact.point)
                  .transpose() *
              force;
  }
  const double left = sum.left(), allowed = kUnbalanced * sum.largest + kLeast_N;
  if (!(left <= allowed)) note("balance", left, allowed);
  judge_torques(grasp, torque, config, runs);
  judge_apart(plan, runs);
}

}  // namespace morphe::verify
