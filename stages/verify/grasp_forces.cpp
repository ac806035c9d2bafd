#include "stages/verify/grasp_forces.hpp"

#include <algorithm>
#include <cmath>

#include "stages/verify/finger_jacobian.hpp"
#include "stages/verify/grasp_config.hpp"
#include "stages/verify/grasp_quality.hpp"
#include "stages/verify/wrench_set.hpp"

namespace morphe::verify {
namespace {

constexpr double kGraspForceTolerance = 1e-6;
constexpr double kMaxImbalanceRatio = 0.03, kImbalanceFloor_n = 2e-3;
constexpr double kMinForceClosureEpsilon = 1e-3;  ///< accuracy to which epsilon is known

/// The sum of all wrenches, and the moments about the contacts' normals that may compensate a part
/// of this sum. Torques and moments are divided by the characteristic length.
struct WrenchBalance {
  Vector6 wrench = Vector6::Zero();
  std::vector<Vec3> torsion_moments;  ///< the largest possible of each contact [N]
  double largest_force = 0;           ///< of the normal forces [N]

  /// Returns the wrench that remains after the moments have compensated as much as possible; solves
  /// the convex problem by coordinate descent over the moments.
  double residual() const {
    std::vector<double> shares(torsion_moments.size(), 0);
    Vec3 torque = wrench.tail<3>();
    for (int round = 0; round < 1000; ++round) {
      for (int k = 0; k < std::ssize(shares); ++k) {
        const double squared_moment = torsion_moments[k].squaredNorm();
        if (!(squared_moment > 0)) continue;
        const Vec3 others = torque - shares[k] * torsion_moments[k];
        shares[k] = std::clamp(-others.dot(torsion_moments[k]) / squared_moment, -1.0, 1.0);
        torque = others + shares[k] * torsion_moments[k];
      }
    }
    return std::hypot(wrench.head<3>().norm(), torque.norm());
  }
};

/// Adds a contact's force to the sum and returns by how much it violates the friction cone [N].
double add_force(const PadContact& contact, const GraspQuality& quality, WrenchBalance& sum) {
  const Vec3 moment_arm = (contact.point - quality.centre_of_mass) / quality.characteristic_length;
  const Vec3 force = contact.normal_force * contact.normal + contact.friction_force;
  sum.wrench.head<3>() += force;
  sum.wrench.tail<3>() += moment_arm.cross(force);
  sum.largest_force = std::max(sum.largest_force, contact.normal_force);
  const double max_friction = quality.friction_coefficient * contact.normal_force;
  const double friction = contact.friction_force.norm();
  const double share = max_friction > 0 ? std::min(1.0, friction / max_friction) : 1;
  sum.torsion_moments.push_back(quality.torsional_friction * contact.normal_force *
                                std::sqrt(1 - share * share) / quality.characteristic_length *
                                contact.normal);
  return std::max(friction - max_friction, std::abs(contact.friction_force.dot(contact.normal)));
}

void verify_torques(const Grasp& grasp, const JointVector& expected, const std::string& config,
                    ViolationLog& violations) {
  const JointVector& torque = grasp.grasp_torque;
  const double error = (torque - expected).cwiseAbs().maxCoeff();
  if (!(error <= kGraspForceTolerance))
    violations.note_plan("grasp_force", "torque", error, kGraspForceTolerance);
  const double max_torque = grasp_config_value(config, "max_joint_torque").value_or(kInfinity);
  const double largest_torque = torque.cwiseAbs().maxCoeff();
  if (!(largest_torque <= max_torque * (1 + kGraspForceTolerance)))
    violations.note_plan("grasp_force", "torque", largest_torque, max_torque);

  const JointVector shift = grasp.servo_target - grasp.grasp_posture;
  const double fitting = torque.squaredNorm() / torque.dot(shift);
  const double stiffness = grasp_config_value(config, "joint_stiffness").value_or(fitting);
  const double deviation = torque.isZero(0) ? shift.cwiseAbs().maxCoeff()
                                            : (shift - torque / stiffness).cwiseAbs().maxCoeff();
  if (!(deviation <= kGraspForceTolerance))
    violations.note_plan("grasp_force", "servo_target", deviation, kGraspForceTolerance);
}

/// Checks that at no sample from the grasp on the joints with a torque are at the servo's target.
void verify_not_in_trajectory(const Plan& plan, ViolationLog& violations) {
  const JointVector& target = plan.grasp.servo_target;
  if ((target - plan.grasp.grasp_posture).cwiseAbs().maxCoeff() <= kGraspForceTolerance) return;
  for (Eigen::Index k = plan.grasp.sample; k < plan.trajectory.position.rows(); ++k) {
    double distance = 0;
    for (Eigen::Index joint = 0; joint < target.size(); ++joint) {
      if (plan.grasp.grasp_torque[joint] == 0) continue;
      distance = std::max(distance, std::abs(plan.trajectory.position(k, joint) - target[joint]));
    }
    if (distance > kGraspForceTolerance) continue;
    violations.note_plan("grasp_force", "trajectory", distance, kGraspForceTolerance);
    return;
  }
}

}  // namespace

void verify_grasp_forces(const RobotModel& robot, const Plan& plan, const std::string& config,
                         ViolationLog& violations) {
  const Grasp& grasp = plan.grasp;
  const std::vector<int> touching = touching_contacts(grasp);
  const auto note = [&](const std::string& subject, double value, double limit) {
    violations.note_plan("grasp_force", subject, value, limit);
  };
  for (int k = 0; k < std::ssize(grasp.contacts); ++k) {
    const PadContact& contact = grasp.contacts[k];
    const bool presses = touching.size() >= 2 && std::ranges::find(touching, k) != touching.end();
    if (!presses &&
        !(std::isnan(contact.normal_force) && contact.friction_force.array().isNaN().all()))
      note(contact.tip + "/normal_force", contact.normal_force, kUnknown);
  }
  if (touching.size() < 2) {
    if (grasp.grasp_torque.size() > 0) note("torque", kUnknown, kUnknown);
    return;
  }
  const Eigen::Index joints = std::ssize(robot.joint_names);
  if (grasp.grasp_torque.size() != joints || grasp.servo_target.size() != joints) {
    // Forces that balance an object exist if the signed epsilon is positive.
    if (grasp.quality.epsilon_lower > kMinForceClosureEpsilon) note("torque", kUnknown, kUnknown);
    return;
  }
  if (!grasp.grasp_torque.allFinite() || !grasp.servo_target.allFinite())
    return violations.note_plan("finite", "grasp/grasp_force", kUnknown, kUnknown);

  const SceneObject& target = *find_object(plan.scene.objects, plan.movement.target);
  const Pose base_from_object =
      recorded_pose(target, plan.trajectory.demonstration_time[grasp.sample]);
  const double limit_n = grasp_config_value(config, "max_finger_force").value_or(kInfinity);
  WrenchBalance balance;
  JointVector torque = JointVector::Zero(joints);
  for (const int row : touching) {
    const PadContact& contact = grasp.contacts[row];
    const double normal_force = contact.normal_force;
    if (!(normal_force >= 0 && normal_force <= limit_n * (1 + kGraspForceTolerance)))
      note(contact.tip + "/normal_force", normal_force, normal_force > limit_n ? limit_n : 0);
    const double excess = add_force(contact, grasp.quality, balance);
    const double rounding = kGraspForceTolerance * std::max(1.0, normal_force);
    if (!(excess <= rounding)) note(contact.tip + "/friction_cone", excess, rounding);
    const auto tip = std::ranges::find(robot.tips, contact.tip, &RobotModel::Tip::name);
    const Vec3 force =
        base_from_object.linear() * (normal_force * contact.normal + contact.friction_force);
    const Eigen::Matrix3Xd jacobian =
        finger_jacobian(robot, grasp.grasp_posture, tip->frame, base_from_object * contact.point);
    torque += jacobian.transpose() * force;
  }
  const double imbalance = balance.residual();
  const double max_imbalance = kMaxImbalanceRatio * balance.largest_force + kImbalanceFloor_n;
  if (!(imbalance <= max_imbalance)) note("force_balance", imbalance, max_imbalance);
  verify_torques(grasp, torque, config, violations);
  verify_not_in_trajectory(plan, violations);
}

}  // namespace morphe::verify
