#include "stages/grasp/quality.hpp"

#include <algorithm>
#include <cmath>

#include "core/closure/ferrari_canny.hpp"
#include "core/closure/grasp_forces.hpp"
#include "core/closure/gravity_margin.hpp"
#include "core/collision/distance.hpp"
#include "core/robot/forward_kinematics.hpp"

namespace morphe::grasp {
namespace {

/// Returns the centroid of a mesh's volume; the origin if there is no volume or no mesh.
Vec3 centre_of_mass(const SceneObject& object) {
  if (object.shape != Shape::mesh) return Vec3::Zero();
  double volume = 0, r = 0;
  Vec3 moment = Vec3::Zero();
  for (const Eigen::Vector3i& corner : object.triangles) {
    const auto vertex = [&](int k) { return object.vertices[corner[k]]; };
    const double part = vertex(0).dot(vertex(1).cross(vertex(2))) / 6;
    volume += part;
    moment += part / 4 * (vertex(0) + vertex(1) + vertex(2));
    r = std::max(r, vertex(0).norm());
  }
  return std::abs(volume) > kMinVolumeRatio * r * r * r ? Vec3(moment / volume) : Vec3::Zero();
}

double max_radius(const SceneObject& object, const Vec3& centre) {
  if (object.shape != Shape::mesh) return collision::bounding_radius({object, nullptr});
  double radius = 0;
  for (const Vec3& vertex : object.vertices) radius = std::max(radius, (vertex - centre).norm());
  return radius;
}

/// The touching contacts and the Jacobian from their forces to joint torques.
struct ContactModel {
  std::vector<int> rows;  ///< rows in Grasp::contacts
  closure::ContactSet set;
  /// [3 c, n] joint torques per unit force at the contact points, in the target's frame.
  Eigen::MatrixXd contact_jacobian;
};

ContactModel contact_model(const collision::CollisionWorld& world, const SceneObject& target,
                           const Pose& base_from_target, const GraspOptions& options,
                           const Grasp& grasp) {
  const robot::Robot& robot = *world.robot;
  ContactModel model;
  model.set.friction = {options.friction_coefficient, options.torsional_friction_m};
  model.set.reference = centre_of_mass(target);
  model.set.torque_scale_m = max_radius(target, model.set.reference);
  for (int k = 0; k < std::ssize(grasp.contacts); ++k) {
    if (grasp.contacts[k].state != ContactState::touching) continue;
    model.rows.push_back(k);
    model.set.contacts.push_back({grasp.contacts[k].point, grasp.contacts[k].normal});
  }
  const Eigen::Index joints = grasp.grasp_posture.size();
  model.contact_jacobian.setZero(3 * std::ssize(model.rows), joints);
  std::vector<Pose> base_from_frame;
  robot::forward_kinematics(robot, grasp.grasp_posture, base_from_frame);
  JointVector slope(joints);
  for (int c = 0; c < std::ssize(model.rows); ++c) {
    const PadContact& contact = grasp.contacts[model.rows[c]];
    const auto tip = std::ranges::find(robot.tips, contact.tip, &RobotModel::Tip::name);
    for (int axis = 0; axis < 3; ++axis) {
      slope.setZero();
      robot::add_point_gradient(robot, base_from_frame, tip->frame, -1,
                                base_from_target * contact.point,
                                base_from_target.linear().col(axis), slope);
      for (const int arm : robot.arm_joints) slope[arm] = 0;  // the arm is assumed to hold the hand
      model.contact_jacobian.row(3 * c + axis) = slope.transpose();
    }
  }
  return model;
}

/// Returns the largest normal force [N] that every finger, each by itself, can exert with joint
/// torques of at most `torque`.
double available_force(const ContactModel& touching, double torque) {
  double min_force_N = kInfinity;
  for (int c = 0; c < std::ssize(touching.rows); ++c) {
    const Eigen::RowVectorXd per_newton = touching.set.contacts[c].normal.transpose() *
                                          touching.contact_jacobian.middleRows<3>(3 * c);
    const double max_torque = per_newton.cwiseAbs().maxCoeff();
    if (max_torque > 0) min_force_N = std::min(min_force_N, torque / max_torque);
  }
  return min_force_N;
}

std::vector<closure::ForceBound> joint_bounds(const ContactModel& touching, double torque) {
  std::vector<closure::ForceBound> bounds;
  for (Eigen::Index joint = 0; joint < touching.contact_jacobian.cols(); ++joint) {
    if (touching.contact_jacobian.col(joint).isZero(1e-9)) continue;
    for (const double sign : {1.0, -1.0}) {
      closure::ForceBound bound;
      bound.upper_bound = torque;
      for (int c = 0; c < std::ssize(touching.rows); ++c) {
        bound.force.push_back(sign * touching.contact_jacobian.col(joint).segment<3>(3 * c));
        bound.moment.push_back(0);
      }
      bounds.push_back(std::move(bound));
    }
  }
  return bounds;
}

bool balances(const closure::GraspForces& squeeze, const GraspOptions& options) {
  return squeeze.max_force_n >= kMinGraspForceRatio * options.max_finger_force &&
         squeeze.residual.norm() <= kMaxResidualRatio * squeeze.max_force_n;
}

/// Returns grasp forces that balance. The distributions that are tried begin with an even one well
/// inside the friction cones, which is then relaxed. The first one that presses with
/// kSufficientForceRatio of the requested force is returned, otherwise the one that presses most.
/// Empty if no forces balance.
closure::GraspForces grasp_forces(const ContactModel& touch, const GraspOptions& options) {
  const double share = options.min_finger_force_share;
  closure::GraspForces strongest;
  for (const auto& [min_share, friction_use] :
       {std::pair{share, kFrictionUse}, std::pair{share, kRelaxedFrictionUse},
        std::pair{share / 3, kRelaxedFrictionUse}, std::pair{0.0, kRelaxedFrictionUse},
        std::pair{0.0, kFullFrictionUse}}) {
    closure::GraspForceOptions request;
    request.max_force_n = options.max_finger_force;
    request.min_force_share = min_share;
    request.friction_cone_share = friction_use;
    closure::GraspForces squeeze = closure::distribute_grasp_forces(
        touch.set, closure::Wrench::Zero(), request, joint_bounds(touch, options.max_joint_torque));
    if (!balances(squeeze, options)) continue;
    if (squeeze.max_force_n >= kSufficientForceRatio * options.max_finger_force) return squeeze;
    if (strongest.forces.empty() || squeeze.max_force_n > strongest.max_force_n)
      strongest = std::move(squeeze);
  }
  return strongest;
}

}  // namespace

void evaluate_grasp(const collision::CollisionWorld& world, double time_s, const Vec3& down,
                    const GraspOptions& options, Grasp& grasp) {
  if (world.target < 0 || grasp.sample < 0 || grasp.contacts.empty()) return;
  const SceneObject& target = world.scene->objects[world.target];
  const Pose base_from_target = recorded_pose(target, time_s);
  const ContactModel touch = contact_model(world, target, base_from_target, options, grasp);
  GraspQuality& quality = grasp.quality;
  quality.friction_coefficient = options.friction_coefficient;
  quality.torsional_friction = options.torsional_friction_m;
  quality.mass = options.mass_kg;
  quality.centre_of_mass = touch.set.reference;
  quality.characteristic_length = touch.set.torque_scale_m;
  if (touch.rows.size() < 2 || !closure::validation_error(touch.set).empty()) return;
  const closure::FerrariCanny epsilon = closure::ferrari_canny(touch.set, closure::ForceLimit::sum);
  quality.epsilon_lower = epsilon.lower;
  quality.epsilon_upper = epsilon.upper;
  const closure::Load load{options.mass_kg, quality.centre_of_mass};
  quality.required_force_worst =
      closure::worst_gravity_margin(touch.set, load).sufficient_force_n(options.mass_kg);
  const Vec3 down_in_target = base_from_target.linear().transpose() * down;
  quality.required_force_gravity =
      closure::gravity_margin(touch.set, load, down_in_target).sufficient_force_n(options.mass_kg);
  quality.available_force = available_force(touch, options.max_joint_torque);

  const closure::GraspForces shared = grasp_forces(touch, options);
  if (shared.forces.empty()) return;
  Eigen::VectorXd forces(touch.contact_jacobian.rows());
  for (int c = 0; c < std::ssize(touch.rows); ++c) {
    PadContact& contact = grasp.contacts[touch.rows[c]];
    const Vec3& force = shared.forces[c].force;
    contact.normal_force = force.dot(contact.normal);
    contact.friction_force = force - contact.normal_force * contact.normal;
    forces.segment<3>(3 * c) = force;
  }
  grasp.grasp_torque = touch.contact_jacobian.transpose() * forces;
  grasp.servo_target = grasp.grasp_posture + grasp.grasp_torque / options.joint_stiffness;
}

}  // namespace morphe::grasp
