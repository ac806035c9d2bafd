#pragma once

#include <vector>

#include "pipeline/motion/robot_table.hpp"
#include "pipeline/solve/quadratic.hpp"

namespace morphe {

/// How much of a term's second derivative is wanted: nothing; what is left of it without the
/// curvature of the kinematics (positive semidefinite); all of it.
enum class Curvature { none, gauss_newton, exact };

/// What the terms pull at one frame with, about the base's origin. A point x with gradient f and
/// curvature m I (f = dF/dx, m I = d²F/dx²) is a force and a mass, and the Hessian by joints is the
/// inertia matrix of such a body: one backward sweep sums it over all frames (add_derivatives).
struct Load {
  Vec3 force = Vec3::Zero();                          ///< sum f
  Vec3 moment = Vec3::Zero();                         ///< sum x × f, and the gradients by rotation
  double mass = 0;                                    ///< sum m
  Vec3 first = Vec3::Zero();                          ///< sum m x
  Vec3 first_and_force = Vec3::Zero();                ///< sum m x - f (exact), m x (Gauss–Newton)
  Eigen::Matrix3d turning = Eigen::Matrix3d::Zero();  ///< what a turn's moment answers to a turn

  void operator+=(const Load& other) {
    force += other.force;
    moment += other.moment;
    mass += other.mass;
    first += other.first;
    first_and_force += other.first_and_force;
    turning += other.turning;
  }
};

/// What a smoothed angle remembers from one evaluation of a descent to the next. Its curvature
/// along its axis falls from 1/e to nothing within the smoothing e; Newton steps stall there unless
/// the slope is followed as a variable of its own (primal-dual Newton of Chan, Golub and Mulet). It
/// only chooses the exact mode's curvature: values and gradients do not depend on it.
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
  std::vector<AngleMemory> angles;  ///< one for each orientation goal; clear() begins a descent

  AngleMemory& angle(std::size_t index) {
    if (angles.size() <= index) angles.resize(index + 1);
    return angles[index];
  }
  void reset(std::size_t frames, Curvature wanted);
  /// A term of the point x that moves with a frame, with its gradient and isotropic curvature.
  void add_force(int frame, const Vec3& x, const Vec3& force, double mass);
  /// weight * ‖x - goal‖².
  void add_point(int frame, const Vec3& x, const Vec3& goal, double weight) {
    const Vec3 away = x - goal;
    value += weight * away.squaredNorm();
    add_force(frame, x, 2 * weight * away, 2 * weight);
  }
  /// A term of a frame's orientation: its gradient and Hessian by a rotation vector about the
  /// base's axes.
  void add_turn(int frame, const Vec3& gradient, const Eigen::Matrix3d& hessian);
};

/// Scratch of add_derivatives.
struct LoadSweep {
  std::vector<Eigen::Matrix<double, 6, 1>> twist;  ///< [frames] per joint rate, moment arm first
  std::vector<int> above;  ///< [frames] next frame upwards that a joint turns
};

/// Adds the loads' value, gradient and (unless the curvature is none) Hessian by joints to `model`.
/// With ancestors i of j: dF/dq_j = S_j · (moment, force), d²F/dq_i dq_j = S_i · I_j S_j, both
/// summed below j; coupled joints add up in the joint that drives them. Uses up the loads.
void add_derivatives(const RobotTable& robot, const std::vector<Pose>& base_from_frame,
                     Loads& loads, LoadSweep& sweep, Quadratic& model);

}  // namespace morphe
