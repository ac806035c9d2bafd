#pragma once

#include <vector>

#include "core/motion/robot_model.hpp"
#include "core/solve/quadratic.hpp"

namespace morphe::humanlike {

/// The part of a term's second derivative that is computed: no part; the Gauss-Newton part without
/// the curvature of the kinematics (positive semidefinite); the exact Hessian.
enum class Curvature { none, gauss_newton, exact };

/// The accumulated derivatives of the terms with respect to the motion of one frame, about the
/// base's origin. A point x with gradient f and curvature m I (f = dF/dx, m I = d²F/dx²)
/// corresponds to a force and a mass, and the Hessian with respect to the joints to the inertia
/// matrix of such a body: one backward sweep sums it over all frames (add_derivatives).
struct Load {
  Vec3 force = Vec3::Zero();        ///< sum f
  Vec3 moment = Vec3::Zero();       ///< sum x × f, and gradients with respect to rotation
  double mass = 0;                  ///< sum m
  Vec3 mass_moment = Vec3::Zero();  ///< sum m x
  /// About the origin, including Hessians with respect to rotation.
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  /// The forces used for the curvature of the kinematics.
  Vec3 multiplier_force = Vec3::Zero();
  /// sum x fᵀ - (x · f) I, and half the moments of rotations.
  Eigen::Matrix3d geometric_stiffness = Eigen::Matrix3d::Zero();

  void operator+=(const Load& other) {
    force += other.force;
    moment += other.moment;
    mass += other.mass;
    mass_moment += other.mass_moment;
    inertia += other.inertia;
    multiplier_force += other.multiplier_force;
    geometric_stiffness += other.geometric_stiffness;
  }
};

/// The state that stiff terms keep from one evaluation of a descent to the next. It only affects
/// the curvature in exact mode, not values and gradients. A step along a curved valley leaves its
/// bottom by a second-order distance; the resulting forces vanish in the next step, and a Hessian
/// that includes them would make that step a bad one. So the curvature of the kinematics is
/// weighted by the forces that the last linear model predicted (as in SQP, in which they are the
/// multipliers), initially zero.
struct PointMemory {
  int frame = -1;
  Vec3 x = Vec3::Zero(), force = Vec3::Zero();
  double mass = 0;
  /// Force at the current position predicted by the last linear model.
  Vec3 multiplier_force = Vec3::Zero();
};
/// The state of an angle. Its curvature along its axis falls from 1/e to zero within the smoothing
/// e, so the gradient is tracked as a separate variable (primal-dual Newton method of Chan, Golub
/// and Mulet).
struct AngleMemory {
  Vec3 half = Vec3::Zero();  ///< half the rotation vector at the last evaluation
  Vec3 dual = Vec3::Zero();  ///< tracked gradient, norm at most 1
  double smooth = 0;         ///< sqrt(‖half‖² + e²) at the last evaluation, initially 0
};

/// The loads of a sum of terms at one position, and the sum's value.
struct Loads {
  Curvature curvature = Curvature::gauss_newton;
  double value = 0;
  /// [frames]; the base, frame -1, does not move and has no load.
  std::vector<Load> on_frame;
  std::vector<PointMemory> points;  ///< in the order in which the terms add them
  std::vector<AngleMemory> angles;  ///< in the same order

  /// Discards the last evaluation, at the beginning of another descent.
  void forget() {
    points.clear();
    angles.clear();
  }
  /// Clears the loads before an evaluation.
  void reset(std::size_t frames, Curvature wanted);
  /// Adds a term of the point x that moves with a frame, with its gradient and isotropic curvature.
  /// The curvature of the kinematics is weighted by `promised` instead of the force.
  void add_force(int frame, const Vec3& x, const Vec3& force, const Vec3& promised, double mass);
  /// Adds weight * ‖x - goal‖². If the goal is to be reached (`to_be_met`), its predicted force is
  /// zero until a linear model predicts another one.
  void add_point(int frame, const Vec3& x, const Vec3& goal, double weight, bool to_be_met);
  /// Adds a term of a frame's orientation: its gradient and Hessian with respect to a rotation
  /// vector about the base's axes.
  void add_rotation(int frame, const Vec3& gradient, const Eigen::Matrix3d& hessian);
  /// Returns the state of the next angle in the order of evaluation.
  AngleMemory& next_angle();

 private:
  std::size_t points_added_ = 0, angles_added_ = 0;
};

/// Buffers of add_derivatives.
struct LoadSweep {
  /// [frames] twist per joint rate, moment arm first.
  std::vector<Eigen::Matrix<double, 6, 1>> twist;
  std::vector<int> parent_moving_frame;  ///< [frames] next ancestor that a joint moves
  std::vector<Eigen::Matrix<double, 6, 1>> displacement;  ///< [frames] twist of a step
};

/// Computes the forces that the points' last linear models predict after a step [variables] from
/// the position of the last evaluation, whose sweep must still be stored.
void predict_multiplier_forces(const RobotModel& robot, const JointVector& step, LoadSweep& sweep,
                               std::vector<PointMemory>& points);

/// Adds the loads' value, gradient and (unless the curvature is none) Hessian with respect to the
/// joints to `model`. With i an ancestor of j: dF/dq_j = S_j · (moment, force), d²F/dq_i dq_j = S_i
/// · I_j S_j, both summed over the subtree of j; coupled joints are added to the joint that drives
/// them. The loads are modified in the process.
void add_derivatives(const RobotModel& robot, const std::vector<Pose>& base_from_frame,
                     Loads& loads, LoadSweep& sweep, solve::Quadratic& model);

}  // namespace morphe::humanlike
