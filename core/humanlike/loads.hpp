#pragma once

#include <vector>

#include "core/motion/robot_table.hpp"
#include "core/solve/quadratic.hpp"

namespace morphe::humanlike {

/// How much of a term's second derivative is wanted: nothing; what is left of it without the
/// curvature of the kinematics (positive semidefinite); all of it.
enum class Curvature { none, gauss_newton, exact };

/// What the terms pull at one frame with, about the base's origin. A point x with gradient f and
/// curvature m I (f = dF/dx, m I = d²F/dx²) is a force and a mass, and the Hessian by joints is the
/// inertia matrix of such a body: one backward sweep sums it over all frames (add_derivatives).
struct Load {
  Vec3 force = Vec3::Zero();   ///< sum f
  Vec3 moment = Vec3::Zero();  ///< sum x × f, and the gradients by rotation
  double mass = 0;             ///< sum m
  Vec3 first = Vec3::Zero();   ///< sum m x
  Eigen::Matrix3d inertia =
      Eigen::Matrix3d::Zero();   ///< about the origin, and Hessians by rotation
  Vec3 promised = Vec3::Zero();  ///< the forces that bend counts with
  Eigen::Matrix3d bend =
      Eigen::Matrix3d::Zero();  ///< sum x fᵀ - (x · f) I, and half turns' moments

  void operator+=(const Load& other) {
    force += other.force;
    moment += other.moment;
    mass += other.mass;
    first += other.first;
    inertia += other.inertia;
    promised += other.promised;
    bend += other.bend;
  }
};

/// What stiff terms remember from one evaluation of a descent to the next, for the exact mode's
/// curvature only: values and gradients do not depend on it. A step along a curved valley leaves
/// its floor by its square; the forces that this raises will be gone after the next step, and a
/// Hessian that believed in them would make that step a bad one. So the curvature of the kinematics
/// is weighed with the forces that the last linear model promised (as in SQP, where they are the
/// multipliers): none at first.
struct PointMemory {
  int frame = -1;
  Vec3 x = Vec3::Zero(), force = Vec3::Zero();
  double mass = 0;
  Vec3 promised = Vec3::Zero();  ///< force at the present position by the last linear model
};
/// The same for an angle: its curvature along its axis falls from 1/e to nothing within the
/// smoothing e, so the slope is followed as a variable of its own (primal-dual Newton of Chan,
/// Golub and Mulet).
struct AngleMemory {
  Vec3 half = Vec3::Zero();   ///< half the rotation vector at the last evaluation
  Vec3 slope = Vec3::Zero();  ///< the slope followed, norm at most 1
  double smooth = 0;          ///< sqrt(‖half‖² + e²) at the last evaluation; 0: none yet
};

/// The loads of a sum of terms at one position, and the terms' value.
struct Loads {
  Curvature curvature = Curvature::gauss_newton;
  double value = 0;
  std::vector<Load> on_frame;       ///< [frames]; frame -1, the base, does not move and takes none
  std::vector<PointMemory> points;  ///< in the order in which the terms add them
  std::vector<AngleMemory> angles;  ///< likewise

  /// Forgets the last evaluation: another descent begins.
  void forget() {
    points.clear();
    angles.clear();
  }
  void reset(std::size_t frames, Curvature wanted);
  /// A term of the point x that moves with a frame, with its gradient and isotropic curvature.
  /// The kinematics' curvature counts with `promised` in place of the force.
  void add_force(int frame, const Vec3& x, const Vec3& force, const Vec3& promised, double mass);
  /// weight * ‖x - goal‖². A goal that is to be met promises no force until a model says otherwise.
  void add_point(int frame, const Vec3& x, const Vec3& goal, double weight, bool to_be_met);
  /// A term of a frame's orientation: its gradient and Hessian by a rotation vector about the
  /// base's axes.
  void add_turn(int frame, const Vec3& gradient, const Eigen::Matrix3d& hessian);
  AngleMemory& next_angle();

 private:
  std::size_t points_added_ = 0, angles_added_ = 0;
};

/// Scratch of add_derivatives.
struct LoadSweep {
  std::vector<Eigen::Matrix<double, 6, 1>> twist;  ///< [frames] per joint rate, moment arm first
  std::vector<int> above;  ///< [frames] next frame upwards that a joint turns
  std::vector<Eigen::Matrix<double, 6, 1>> moved;  ///< [frames] twist of a step
};

/// Fills what the points' last linear models promise after a step [variables] from the position of
/// the last evaluation, whose sweep is still there.
void promise(const RobotTable& robot, const JointVector& step, LoadSweep& sweep,
             std::vector<PointMemory>& points);

/// Adds the loads' value, gradient and (unless the curvature is none) Hessian by joints to `model`.
/// With ancestors i of j: dF/dq_j = S_j · (moment, force), d²F/dq_i dq_j = S_i · I_j S_j, both
/// summed below j; coupled joints add up in the joint that drives them. Uses up the loads.
void add_derivatives(const RobotTable& robot, const std::vector<Pose>& base_from_frame,
                     Loads& loads, LoadSweep& sweep, solve::Quadratic& model);

}  // namespace morphe::humanlike
