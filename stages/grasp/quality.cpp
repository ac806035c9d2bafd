#include "stages/grasp/quality.hpp"

#include <algorithm>
#include <cmath>

#include "core/closure/ferrari_canny.hpp"
#include "core/closure/gravity_margin.hpp"
#include "core/closure/share_forces.hpp"
#include "core/collision/distance.hpp"
#include "core/robot/forward.hpp"

namespace morphe::grasp {
namespace {

/// The centre of what a closed mesh encloses; of an open one, or one without volume, the origin.
Vec3 centre_of(const SceneObject& object) {
  if (object.shape != Shape::mesh) return Vec3::Zero();
  double volume = 0, size = 0;
  Vec3 first = Vec3::Zero();
  for (const Eigen::Vector3i& corner : object.triangles) {
    const auto at = [&](int k) { return object.vertices[static_cast<std::size_t>(corner[k])]; };
    const double part = at(0).dot(at(1).cross(at(2))) / 6;
    volume += part;
    first += part / 4 * (at(0) + at(1) + at(2));
    size = std::max(size, at(0).norm());
  }
  constexpr double kFlat = 1e-6;  // of the cube that holds it
  return std::abs(volume) > kFlat * size * size * size ? Vec3(first / volume) : Vec3::Zero();
}

/// The largest distance of the surface from a point.
double reach_from(const SceneObject& object, const Vec3& centre) {
  if (object.shape != Shape::mesh) return collision::bounding_radius({object, nullptr});
  double most = 0;
  for (const Vec3& vertex : object.vertices) most = std::max(most, (vertex - centre).norm());
  return most;
}

/// The contacts that touch, and how the joints feel forces at them.
struct Touching {
  std::vector<std::size_t> rows;  ///< of Grasp::contacts
  closure::ContactSet set;
  /// [3 c, n] torques of the joints by forces at the points, in the target's frame.
  Eigen::MatrixXd lever;
};

Touching touching(const collision::CollisionWorld& world, const SceneObject& target,
                  const Pose& base_from_target, const GraspOptions& options, const Grasp& grasp) {
  const robot::Robot& robot = *world.robot;
  Touching found;
  found.set.friction = {options.friction, options.torsion_m};
  found.set.reference = centre_of(target);
  found.set.torque_scale_m = reach_from(target, found.set.reference);
  for (std::size_t k = 0; k < grasp.contacts.size(); ++k) {
    if (!(grasp.contacts[k].gap <= kTouches_m)) continue;
    found.rows.push_back(k);
    found.set.contacts.push_back({grasp.contacts[k].point, grasp.contacts[k].normal});
  }
  const Eigen::Index joints = grasp.hand_posture.size();
  found.lever.setZero(3 * static_cast<Eigen::Index>(found.rows.size()), joints);
  std::vector<Pose> base_from_frame;
  robot::forward(robot, grasp.hand_posture, base_from_frame);
  JointVector slope(joints);
  for (std::size_t c = 0; c < found.rows.size(); ++c) {
    const PadContact& contact = grasp.contacts[found.rows[c]];
    const auto tip = std::ranges::find(robot.tips, contact.tip, &RobotTable::Tip::name);
    for (int axis = 0; axis < 3; ++axis) {
      slope.setZero();
      robot::add_point_slope(robot, base_from_frame, tip->frame, -1,
                             base_from_target * contact.point, base_from_target.linear().col(axis),
                             slope);
      for (const int arm : robot.arm_joints)
        slope[arm] = 0;  // which holds the hand, whatever it does
      found.lever.row(3 * static_cast<Eigen::Index>(c) + axis) = slope.transpose();
    }
  }
  return found;
}

/// The least of what the fingers can press with, each by itself.
double can_give(const Touching& touching, double torque) {
  double least = kInfinity;
  for (std::size_t c = 0; c < touching.rows.size(); ++c) {
    const Eigen::RowVectorXd per_newton =
        touching.set.contacts[c].normal.transpose() *
        touching.lever.middleRows<3>(3 * static_cast<Eigen::Index>(c));
    const double most = per_newton.cwiseAbs().maxCoeff();
    if (most > 0) least = std::min(least, torque / most);
  }
  return least;
}

std::vector<closure::ForceBound> joint_bounds(const Touching& touching, double torque) {
  std::vector<closure::ForceBound> bounds;
  for (Eigen::Index joint = 0; joint < touching.lever.cols(); ++joint) {
    if (touching.lever.col(joint).isZero(1e-9)) continue;
    for (const double sign : {1.0, -1.0}) {
      closure::ForceBound bound;
      bound.most = torque;
      for (std::size_t c = 0; c < touching.rows.size(); ++c) {
        bound.force.push_back(
            sign * touching.lever.col(joint).segment<3>(3 * static_cast<Eigen::Index>(c)));
        bound.moment.push_back(0);
      }
      bounds.push_back(std::move(bound));
    }
  }
  return bounds;
}

constexpr double kFaint = 0.05;     ///< of the force asked for: no squeeze
constexpr double kBalanced = 1e-3;  ///< of the largest force, that may be left over

bool balances(const closure::Squeeze& squeeze, const GraspOptions& options) {
  return squeeze.largest_n >= kFaint * options.squeeze_force &&
         squeeze.residual.norm() <= kBalanced * squeeze.largest_n;
}

/// Evenly shared and well inside the cones, or as near to that as balances: the first one that
/// presses with half of the force asked for, else the one that presses most. Nothing balances: no
/// forces.
closure::Squeeze squeeze_of(const Touching& touch, const GraspOptions& options) {
  struct Way {
    double share, friction_use;
  };
  const double share = options.squeeze_share;
  closure::Squeeze best;
  for (const Way way :
       {Way{share, 0.7}, Way{share, 0.95}, Way{share / 3, 0.95}, Way{0, 0.95}, Way{0, 1}}) {
    closure::SqueezeOptions asked;
    asked.largest_n = options.squeeze_force;
    asked.share = way.share;
    asked.friction_use = way.friction_use;
    closure::Squeeze found = closure::share_forces(touch.set, closure::Wrench::Zero(), asked,
                                                   joint_bounds(touch, options.joint_torque));
    if (!balances(found, options)) continue;
    const bool enough = found.largest_n >= 0.5 * options.squeeze_force;
    if (enough || best.forces.empty() || found.largest_n > best.largest_n) best = std::move(found);
    if (enough) break;
  }
  return best;
}

}  // namespace

void judge_grasp(const collision::CollisionWorld& world, double time_s, const Vec3& down,
                 const GraspOptions& options, Grasp& grasp) {
  if (world.target < 0 || grasp.sample < 0 || grasp.contacts.empty()) return;
  const SceneObject& target = world.scene->objects[static_cast<std::size_t>(world.target)];
  const Pose base_from_target = recorded_pose(target, time_s);
  const Touching touch = touching(world, target, base_from_target, options, grasp);
  GraspQuality& quality = grasp.quality;
  quality.friction = options.friction;
  quality.torsion = options.torsion_m;
  quality.mass = options.mass_kg;
  quality.centre = touch.set.reference;
  quality.torque_scale = touch.set.torque_scale_m;
  if (touch.rows.size() < 2 || !closure::why_invalid(touch.set).empty()) return;
  const closure::FerrariCanny epsilon = closure::ferrari_canny(touch.set, closure::ForceLimit::sum);
  quality.epsilon_lower = epsilon.lower;
  quality.epsilon_upper = epsilon.upper;
  const closure::Load load{options.mass_kg, quality.centre};
  quality.needed_worst =
      closure::worst_gravity_margin(touch.set, load).newtons_enough(options.mass_kg);
  const Vec3 down_in_target = base_from_target.linear().transpose() * down;
  quality.needed_down =
      closure::gravity_margin(touch.set, load, down_in_target).newtons_enough(options.mass_kg);
  quality.given = can_give(touch, options.joint_torque);

  const closure::Squeeze shared = squeeze_of(touch, options);
  if (shared.forces.empty()) return;
  Eigen::VectorXd forces(touch.lever.rows());
  for (std::size_t c = 0; c < touch.rows.size(); ++c) {
    PadContact& contact = grasp.contacts[touch.rows[c]];
    const Vec3& force = shared.forces[c].force;
    contact.force = force.dot(contact.normal);
    contact.friction = force - contact.force * contact.normal;
    forces.segment<3>(3 * static_cast<Eigen::Index>(c)) = force;
  }
  grasp.squeeze_torque = touch.lever.transpose() * forces;
  grasp.squeeze_posture = grasp.hand_posture + grasp.squeeze_torque / options.joint_stiffness;
}

}  // namespace morphe::grasp
