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

/// Returns the centroid of the volume that a mesh encloses; the origin if the mesh has no volume or
/// the object is no mesh.
Vec3 centre_of_mass(const SceneObject& object) {
  if (object.shape != Shape::mesh) return Vec3::Zero();
  double volume = 0, size = 0;
  Vec3 first = Vec3::Zero();
  for (const Eigen::Vector3i& corner : object.triangles) {
    const auto at = [&](int k) { return object.vertices[corner[k]]; };
    const double part = at(0).dot(at(1).cross(at(2))) / 6;
    volume += part;
    first += part / 4 * (at(0) + at(1) + at(2));
    size = std::max(size, at(0).norm());
  }
  constexpr double kMinVolumeRatio = 1e-6;  // relative to the cube of the mesh's radius
  return std::abs(volume) > kMinVolumeRatio * size * size * size ? Vec3(first / volume)
                                                                 : Vec3::Zero();
}

/// Returns the largest distance of the surface from a point.
double max_radius(const SceneObject& object, const Vec3& centre) {
  if (object.shape != Shape::mesh) return collision::bounding_radius({object, nullptr});
  double most = 0;
  for (const Vec3& vertex : object.vertices) most = std::max(most, (vertex - centre).norm());
  return most;
}

/// The touching contacts and the Jacobian from their forces to joint torques.
struct ContactModel {
  std::vector<std::size_t> rows;  ///< rows in Grasp::contacts
  closure::ContactSet set;
  /// [3 c, n] joint torques per unit force at the contact points, in the target's frame.
  Eigen::MatrixXd contact_jacobian;
};

ContactModel contact_model(const collision::CollisionWorld& world, const SceneObject& target,
                           const Pose& base_from_target, const GraspOptions& options,
                           const Grasp& grasp) {
  const robot::Robot& robot = *world.robot;
  ContactModel found;
  found.set.friction = {options.friction_coefficient, options.torsional_friction_m};
  found.set.reference = centre_of_mass(target);
  found.set.torque_scale_m = max_radius(target, found.set.reference);
  for (std::size_t k = 0; k < grasp.contacts.size(); ++k) {
    if (!(grasp.contacts[k].signed_distance <= kMaxContactGap_m)) continue;
    found.rows.push_back(k);
    found.set.contacts.push_back({grasp.contacts[k].point, grasp.contacts[k].normal});
  }
  const Eigen::Index joints = grasp.grasp_posture.size();
  found.contact_jacobian.setZero(3 * static_cast<Eigen::Index>(found.rows.size()), joints);
  std::vector<Pose> base_from_frame;
  robot::forward_kinematics(robot, grasp.grasp_posture, base_from_frame);
  JointVector slope(joints);
  for (std::size_t c = 0; c < found.rows.size(); ++c) {
    const PadContact& contact = grasp.contacts[found.rows[c]];
    const auto tip = std::ranges::find(robot.tips, contact.tip, &RobotModel::Tip::name);
    for (int axis = 0; axis < 3; ++axis) {
      slope.setZero();
      robot::add_point_gradient(robot, base_from_frame, tip->frame, -1,
                                base_from_target * contact.point,
                                base_from_target.linear().col(axis), slope);
      for (const int arm : robot.arm_joints) slope[arm] = 0;  // the arm is assumed to hold the hand
      found.contact_jacobian.row(3 * static_cast<Eigen::Index>(c) + axis) = slope.transpose();
    }
  }
  return found;
}

/// Returns the smallest normal force that each of the fingers can exert alone.
double available_force(const ContactModel& touching, double torque) {
  double least = kInfinity;
  for (std::size_t c = 0; c < touching.rows.size(); ++c) {
    const Eigen::RowVectorXd per_newton =
        touching.set.contacts[c].normal.transpose() *
        touching.contact_jacobian.middleRows<3>(3 * static_cast<Eigen::Index>(c));
    const double most = per_newton.cwiseAbs().maxCoeff();
    if (most > 0) least = std::min(least, torque / most);
  }
  return least;
}

std::vector<closure::ForceBound> joint_bounds(const ContactModel& touching, double torque) {
  std::vector<closure::ForceBound> bounds;
  for (Eigen::Index joint = 0; joint < touching.contact_jacobian.cols(); ++joint) {
    if (touching.contact_jacobian.col(joint).isZero(1e-9)) continue;
    for (const double sign : {1.0, -1.0}) {
      closure::ForceBound bound;
      bound.upper_bound = torque;
      for (std::size_t c = 0; c < touching.rows.size(); ++c) {
        bound.force.push_back(sign * touching.contact_jacobian.col(joint).segment<3>(
                                         3 * static_cast<Eigen::Index>(c)));
        bound.moment.push_back(0);
      }
      bounds.push_back(std::move(bound));
    }
  }
  return bounds;
}

/// Share of the requested force below which there is no squeeze.
constexpr double kMinGraspForceRatio = 0.05;
/// Largest unbalanced force, as a share of the largest force.
constexpr double kMaxResidualRatio = 1e-3;

bool balances(const closure::GraspForces& squeeze, const GraspOptions& options) {
  return squeeze.max_force_n >= kMinGraspForceRatio * options.max_finger_force &&
         squeeze.residual.norm() <= kMaxResidualRatio * squeeze.max_force_n;
}

/// Returns grasp forces that are evenly distributed and well inside the friction cones, relaxed as
/// far as balance requires: the first distribution that presses with half of the requested force,
/// otherwise the one that presses most. Empty if no forces balance.
closure::GraspForces grasp_forces(const ContactModel& touch, const GraspOptions& options) {
  struct ForceSettings {
    double share, friction_use;
  };
  const double share = options.min_finger_force_share;
  closure::GraspForces best;
  for (const ForceSettings way :
       {ForceSettings{share, 0.7}, ForceSettings{share, 0.95}, ForceSettings{share / 3, 0.95},
        ForceSettings{0, 0.95}, ForceSettings{0, 1}}) {
    closure::GraspForceOptions asked;
    asked.max_force_n = options.max_finger_force;
    asked.min_force_share = way.share;
    asked.friction_cone_share = way.friction_use;
    closure::GraspForces found = closure::distribute_grasp_forces(
        touch.set, closure::Wrench::Zero(), asked, joint_bounds(touch, options.max_joint_torque));
    if (!balances(found, options)) continue;
    const bool enough = found.max_force_n >= 0.5 * options.max_finger_force;
    if (enough || best.forces.empty() || found.max_force_n > best.max_force_n)
      best = std::move(found);
    if (enough) break;
  }
  return best;
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
  for (std::size_t c = 0; c < touch.rows.size(); ++c) {
    PadContact& contact = grasp.contacts[touch.rows[c]];
    const Vec3& force = shared.forces[c].force;
    contact.normal_force = force.dot(contact.normal);
    contact.friction_force = force - contact.normal_force * contact.normal;
    forces.segment<3>(3 * static_cast<Eigen::Index>(c)) = force;
  }
  grasp.grasp_torque = touch.contact_jacobian.transpose() * forces;
  grasp.servo_target = grasp.grasp_posture + grasp.grasp_torque / options.joint_stiffness;
}

}  // namespace morphe::grasp
