#pragma once

#include <vector>

#include "core/motion/robot_model.hpp"
#include "core/solve/quadratic.hpp"

namespace morphe::humanlike {

/// The part of a term's second derivative that is computed.
enum class Curvature {
  none,
  gauss_newton,  ///< without the curvature of the kinematics: positive semidefinite
  exact,         ///< with it, as PointMemory and AngleMemory weight it
};

/// The sums of the terms' derivatives with respect to the motion of one frame, about the base's
/// origin. A term F of a point x corresponds to a force f = dF/dx and a mass m at the point, with
/// d²F/dx² = m I. The Hessian with respect to the joints then corresponds to the inertia matrix of
/// a chain of such bodies: add_derivatives() computes it in one backward sweep over the frames.
struct Load {
  Vec3 force = Vec3::Zero();        ///< sum f
  Vec3 moment = Vec3::Zero();       ///< sum x × f, and gradients with respect to rotation
  double mass = 0;                  ///< sum m
  Vec3 mass_moment = Vec3::Zero();  ///< sum m x
  /// sum m ((x · x) I - x xᵀ), and Hessians with respect to rotation.
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  Vec3 multiplier_force = Vec3::Zero();  ///< sum p, the forces of PointMemory::multiplier_force
  /// sum x pᵀ - (x · p) I, less half the cross-product matrices of gradients by rotation.
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

/// The memory of a point's term from one evaluation of a descent to the next. It only affects the
/// curvature in exact mode, not values and gradients. A step along a curved valley leaves the
/// valley's bottom by a second-order distance. The forces that this causes vanish in the next step,
/// and a Hessian that includes them would spoil that step. So the curvature of the kinematics is
/// weighted by the forces that the last linear model predicted, as by the multipliers of SQP.
struct PointMemory {
  int frame = -1;
  Vec3 x = Vec3::Zero(), force = Vec3::Zero();  ///< at the last evaluation
  double mass = 0;
  Vec3 multiplier_force = Vec3::Zero();  ///< predicted for the next one, see Loads::add_point()
};
/// The memory of an angle's term. The curvature along the angle's axis falls from 1/e to zero
/// within the smoothing e, so the gradient is tracked as a separate variable (primal-dual Newton of
/// Chan, Golub and Mulet).
struct AngleMemory {
  Vec3 half = Vec3::Zero();  ///< half the rotation vector at the last evaluation
  Vec3 dual = Vec3::Zero();  ///< tracked gradient, norm at most 1
  double smooth = 0;  ///< sqrt(‖half‖² + e²) at the last evaluation, 0 before the first
};

/// The loads of a sum of terms at one position, and the sum's value.
struct Loads {
  Curvature curvature = Curvature::gauss_newton;
  double value = 0;
  std::vector<Load> on_frame;  ///< [frames]; loads on the base, which does not move, are dropped
  std::vector<PointMemory> points;  ///< in the order in which the terms add them, always the same
  std::vector<AngleMemory> angles;  ///< likewise

  /// Discards the memory, at the beginning of another descent.
  void forget() {
    points.clear();
    angles.clear();
  }
  /// Clears the loads, but not the memory, before an evaluation.
  void reset(std::size_t frames, Curvature wanted);
  /// Adds a term of the point x that moves with a frame: its gradient `force` and its curvature
  /// mass · I. The curvature of the kinematics is weighted by `predicted` instead of the force.
  void add_force(int frame, const Vec3& x, const Vec3& force, const Vec3& predicted, double mass);
  /// Adds weight * ‖x - goal‖². At the first evaluation of a descent, the predicted force is zero
  /// if the goal is expected to be met exactly (`to_be_met`), else the force itself.
  void add_point(int frame, const Vec3& x, const Vec3& goal, double weight, bool to_be_met);
  /// Adds a term of a frame's orientation: its gradient and Hessian with respect to a rotation
  /// vector about the base's axes.
  void add_rotation(int frame, const Vec3& gradient, const Eigen::Matrix3d& hessian);
  /// Adds weight * sqrt(d² + e²), with d = θ / 2 half the angle from `goal` to `current` about the
  /// axis n, and e the smoothing [rad]. With respect to a rotation vector about the base's axes,
  /// the gradient is weight * s n, s = d / (2 sqrt(d² + e²)). The curvature perpendicular to n is
  /// weight * s cot(d) / 2. That along n, weight * e² / (4 sqrt(d² + e²)³), is evaluated with
  /// AngleMemory::dual in exact mode, and replaced by weight / (4 sqrt(d² + e²)) otherwise.
  void add_angle(int frame, const Quat& current, const Quat& goal, double weight, double smoothing);
  /// Adds weight * ‖current - goal‖² for unit vectors, of which `current` turns with the frame. The
  /// curvature is that of the chord in exact mode, else that at a goal that is met.
  void add_direction(int frame, const Vec3& current, const Vec3& goal, double weight);

 private:
  std::size_t points_added_ = 0, angles_added_ = 0;
};

/// Buffers of add_derivatives.
struct LoadSweep {
  /// [frames] Twist per rate of the frame's joint: rotation, then velocity at the base's origin.
  std::vector<Eigen::Matrix<double, 6, 1>> twist;
  std::vector<int> parent_moving_frame;                   ///< [frames] ancestor that a joint moves
  std::vector<Eigen::Matrix<double, 6, 1>> displacement;  ///< [frames] twist of a step
};

/// Computes the multiplier forces of the points: those that the linear model of the last evaluation
/// predicts after a step [variables] from there. `sweep` must be as add_derivatives() left it then.
void predict_multiplier_forces(const RobotModel& robot, const JointVector& step, LoadSweep& sweep,
                               std::vector<PointMemory>& points);

/// Adds the loads' value, gradient and (unless the curvature is none) Hessian to `model`, and fills
/// the sweep's twists S. With (moment, force) and the inertia I summed over the subtree of frame j,
/// and i an ancestor of j or j itself:
///   dF/dq_j = S_j · (moment_j, force_j),   d²F/dq_i dq_j = S_i · I_j S_j.
/// Coupled frames count for the joint that drives them. If the model has three variables more than
/// the robot has joints, these are an offset of all goals. Afterwards the loads are those sums.
void add_derivatives(const RobotModel& robot, const std::vector<Pose>& base_from_frame,
                     Loads& loads, LoadSweep& sweep, solve::Quadratic& model);

}  // namespace morphe::humanlike
