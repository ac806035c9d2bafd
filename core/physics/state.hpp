#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/geometry.hpp"
#include "core/physics/model.hpp"

namespace morphe::physics {

/// The complete state between two steps: a simulation restored from it continues bit for bit like
/// the original one. It fits every model with the same bodies, joints and actuators.
struct Snapshot {
  double time_s = 0;
  std::vector<double> position, velocity, control;
  std::vector<double> acceleration;  ///< warm start of the solver
};

/// A contact of two geoms.
struct GeomContact {
  int first = 0, second = 0;  ///< indices of the geoms
  Vec3 point, normal;         ///< unit, from the first to the second
  double distance = 0;        ///< negative values are the penetration depth [m]
  double force = 0;           ///< normal force [N]
};

/// A simulation of a model, which must outlive it; each thread needs its own. All poses are in the
/// world frame. After a step, bodies and contacts are those at its begin, joints those at its end.
/// For every joint except free joints, the motors provide the forces that gravity, the robot's own
/// motion and the commanded accelerations require (inverse dynamics), in addition to the servo
/// forces.
class State {
 public:
  /// Starts a simulation at the initial state of the model.
  explicit State(const Model& model);
  ~State();
  State(State&&) noexcept;

  /// Returns the simulated time [s].
  double time_s() const;
  /// Sets the position of a joint.
  void set_joint(int joint, double value);
  /// Returns the position of a joint.
  double joint(int joint) const;
  /// Sets the pose of a free body, at rest.
  void set_body(int body, const Pose& pose);
  /// Returns the pose of a body.
  Pose body(int body) const;
  /// Sets the control input of an actuator.
  void set_control(int actuator, double value);
  /// Sets the acceleration of a joint that its motor compensates, until it is changed; initially 0
  /// [rad/s^2 or m/s^2].
  void set_acceleration(int joint, double value);
  /// Returns the servo force before the motor's limit in the last step [N m or N].
  double commanded_force(int actuator) const;
  /// Returns the total force of the motor in the last step: the servo force within its limit plus
  /// the compensation [N m or N].
  double applied_force(int actuator) const;
  /// Applies a force to a body's centre of mass, until it is changed [N].
  void apply_force(int body, const Vec3& force);

  /// Computes the poses that follow from the current joint and body positions.
  void update_poses();
  /// Simulates one time step of the model. Returns nullopt, or the problem that occurred: invalid
  /// or huge numbers, or contacts that were omitted. The engine then continues silently from its
  /// initial state, so this state is no longer valid. Throws EngineError if the engine failed; the
  /// state is then invalid too.
  std::optional<std::string> step();
  /// Returns the contacts of the last step.
  void contacts(std::vector<GeomContact>& out) const;

  /// Returns the complete state.
  Snapshot snapshot() const;
  /// Restores a complete state.
  void restore(const Snapshot& snapshot);

 private:
  struct Running;
  const Model* model_;
  std::unique_ptr<Running> running_;
};

}  // namespace morphe::physics
