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

/// The sum of all wrenches, and the moments about the normals that may compensate part of it.
struct WrenchBalance {
  Vector6 wrench = Vector6::Zero();
  std::vector<Vec3> torsion_moments;   ///< largest moments divided by the torque scale [N]
  std::vector<double> torsion_shares;  ///< share of each moment, -1 to 1
  double largest = 0;

  /// Returns the remaining wrench after the moments have compensated as much as possible; solves
  /// the convex problem by coordinate descent over the moments.
  double residual() {
    torsion_shares.assign(torsion_moments.size(), 0);
    Vec3 torque = wrench.tail<3>();
    for (int round = 0; round < 1000; ++round) {
      for (std::size_t k = 0; k < torsion_moments.size(); ++k) {
        const double length = torsion_moments[k].squaredNorm();
        if (!(length > 0)) continue;
        const Vec3 others = torque - torsion_shares[k] * torsion_moments[k];
        torsion_shares[k] = std::clamp(-others.dot(torsion_moments[k]) / length, -1.0, 1.0);
        torque = others + torsion_shares[k] * torsion_moments[k];
      }
    }
    return std::hypot(wrench.head<3>().norm(), torque.norm());
  }
};

/// Adds a contact's force to the sum and returns its distance from the friction cone [N].
double add_force(const PadContact& contact, const GraspQuality& quality, WrenchBalance& sum) {
  const Vec3 lever = (contact.point - quality.centre_of_mass) / quality.characteristic_length;
  const Vec3 force = contact.normal_force * contact.normal + contact.friction_force;
  sum.wrench.head<3>() += force;
  sum.wrench.tail<3>() += lever.cross(force);
  sum.largest = std::max(sum.largest, contact.normal_force);
  const double most = quality.friction_coefficient * contact.normal_force,
               used = contact.friction_force.norm();
  const double share = most > 0 ? std::min(1.0, used / most) : 1;
  sum.torsion_moments.push_back(quality.torsional_friction * contact.normal_force *
                                std::sqrt(1 - share * share) / quality.characteristic_length *
                                contact.normal);
  return std::max(used - most, std::abs(contact.friction_force.dot(contact.normal)));
}

void verify_torques(const Grasp& grasp, const JointVector& expected, const std::string& config,
                    ViolationCollector& runs) {
  const JointVector& torque = grasp.grasp_torque;
  const double off = (torque - expected).cwiseAbs().maxCoeff();
  if (!(off <= kGraspForceTolerance))
    runs.note_plan("grasp_force", "torque", off, kGraspForceTolerance);
  const double most = grasp_config_value(config, "max_joint_torque").value_or(kInfinity);
  const double largest = torque.cwiseAbs().maxCoeff();
  if (!(largest <= most * (1 + kGraspForceTolerance)))
    runs.note_plan("grasp_force", "torque", largest, most);

  const JointVector turned = grasp.servo_target - grasp.grasp_posture;
  const double fitting = torque.squaredNorm() / torque.dot(turned);
  const double stiffness = grasp_config_value(config, "joint_stiffness").value_or(fitting);
  const double beside = torque.isZero(0) ? turned.cwiseAbs().maxCoeff()
                                         : (turned - torque / stiffness).cwiseAbs().maxCoeff();
  if (!(beside <= kGraspForceTolerance))
    runs.note_plan("grasp_force", "servo_target", beside, kGraspForceTolerance);
}

/// Checks that no sample of the trajectory has the squeeze's posture.
void verify_not_in_trajectory(const Plan& plan, ViolationCollector& runs) {
  const JointVector& target = plan.grasp.servo_target;
  if ((target - plan.grasp.grasp_posture).cwiseAbs().maxCoeff() <= kGraspForceTolerance) return;
  for (Eigen::Index k = plan.grasp.sample; k < plan.trajectory.position.rows(); ++k) {
    double off = 0;
    for (Eigen::Index joint = 0; joint < target.size(); ++joint) {
      if (plan.grasp.grasp_torque[joint] == 0) continue;
      off = std::max(off, std::abs(plan.trajectory.position(k, joint) - target[joint]));
    }
    if (off > kGraspForceTolerance) continue;
    runs.note_plan("grasp_force", "trajectory", off, kGraspForceTolerance);
    return;
  }
}

}  // namespace

void verify_grasp_forces(const RobotModel& robot, const Plan& plan, const std::string& config,
                         ViolationCollector& runs) {
  const Grasp& grasp = plan.grasp;
  const std::vector<std::size_t> touching = touching_contacts(grasp);
  const auto note = [&](const std::string& subject, double value, double limit) {
    runs.note_plan("grasp_force", subject, value, limit);
  };
  for (std::size_t k = 0; k < grasp.contacts.size(); ++k) {
    const PadContact& contact = grasp.contacts[k];
    const bool presses = touching.size() >= 2 && std::ranges::find(touching, k) != touching.end();
    if (!presses &&
        !(std::isnan(contact.normal_force) && contact.friction_force.array().isNaN().all()))
      note(contact.tip + "/normal_force", contact.normal_force, kUnknown);
  }
  const auto joints = static_cast<Eigen::Index>(robot.joints());
  const bool there = grasp.grasp_torque.size() == joints && grasp.servo_target.size() == joints;
  if (touching.size() < 2) {
    if (grasp.grasp_torque.size() > 0) note("torque", kUnknown, kUnknown);
    return;
  }
  if (!there) {
    // Forces that balance an object exist if the signed epsilon is positive.
    if (grasp.quality.epsilon_lower > kMinForceClosureEpsilon) note("torque", kUnknown, kUnknown);
    return;
  }
  if (!grasp.grasp_torque.allFinite() || !grasp.servo_target.allFinite())
    return runs.note_plan("finite", "grasp/grasp_force", kUnknown, kUnknown);

  const SceneObject& target = *find_object(plan.scene.objects, plan.movement.target);
  const Pose base_from_object =
      recorded_pose(target, plan.trajectory.demonstration_time[grasp.sample]);
  const double most = grasp_config_value(config, "max_finger_force").value_or(kInfinity);
  WrenchBalance sum;
  JointVector torque = JointVector::Zero(joints);
  for (const std::size_t row : touching) {
    const PadContact& contact = grasp.contacts[row];
    if (!(contact.normal_force >= 0 && contact.normal_force <= most * (1 + kGraspForceTolerance)))
      note(contact.tip + "/normal_force", contact.normal_force,
           contact.normal_force > most ? most : 0);
    const double outside = add_force(contact, grasp.quality, sum);
    const double rounding = kGraspForceTolerance * std::max(1.0, contact.normal_force);
    if (!(outside <= rounding)) note(contact.tip + "/friction_cone", outside, rounding);
    const auto tip = std::ranges::find(robot.tips, contact.tip, &RobotModel::Tip::name);
    const Vec3 force = base_from_object.linear() *
                       (contact.normal_force * contact.normal + contact.friction_force);
    torque +=
        finger_jacobian(robot, grasp.grasp_posture, tip->frame, base_from_object * contact.point)
            .transpose() *
        force;
  }
  const double left = sum.residual(),
               allowed = kMaxImbalanceRatio * sum.largest + kImbalanceFloor_n;
  if (!(left <= allowed)) note("force_balance", left, allowed);
  verify_torques(grasp, torque, config, runs);
  verify_not_in_trajectory(plan, runs);
}

}  // namespace morphe::verify
