#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/geometry.hpp"
#include "core/physics/model.hpp"

namespace morphe::physics {

/// The complete state between two steps: a simulation restored from it continues bit for bit like
/// the original one if the accelerations and forces that the caller sets are the same. It fits
/// every model with the same bodies, joints and actuators.
struct Snapshot {
  double time_s = 0;
  std::vector<double> position, velocity, control;  ///< MuJoCo's qpos, qvel, ctrl
  std::vector<double> acceleration;                 ///< from which the solver starts
};

/// A contact of two geoms.
struct GeomContact {
  int first = 0, second = 0;  ///< indices of the geoms
  Vec3 point, normal;         ///< normal: unit, from the first to the second
  double distance = 0;        ///< < 0 is the penetration depth [m]
  double force = 0;           ///< normal force [N]
};

/// A simulation of a model, which must outlive it. Each thread needs its own. All poses are in the
/// world frame. After a step, bodies and contacts are those at its begin, joints those at its end.
/// To the servo forces of hinges and slides, motors add the forces that gravity, the present motion
/// and the accelerations of set_acceleration() require (inverse dynamics).
class State {
 public:
  /// Starts a simulation at the initial state of the model.
  explicit State(const Model& model);
  ~State();
  State(State&&) noexcept;

  /// Returns the simulated time [s].
  double time_s() const;
  /// Sets the position of a hinge or slide [rad or m]; its velocity stays.
  void set_joint(int joint, double value);
  /// Returns the position of a hinge or slide [rad or m].
  double joint(int joint) const;
  /// Sets the pose of a body with a free joint, at rest.
  void set_body(int body, const Pose& pose);
  /// Returns the pose of a body.
  Pose body(int body) const;
  /// Sets the control input of an actuator, in its own unit, from now on.
  void set_control(int actuator, double value);
  /// Sets the acceleration that the motor of a hinge or slide compensates from now on [rad/s^2 or
  /// m/s^2]. It is 0 at first.
  void set_acceleration(int joint, double value);
  /// Returns the servo's force in the last step, not clamped to the motor's limit [N m or N].
  double commanded_force(int actuator) const;
  /// Returns the motor's force in the last step: clamped servo force + compensation [N m or N].
  double applied_force(int actuator) const;
  /// Applies a force at a body's centre of mass from now on [N]; it replaces the previous one.
  void apply_force(int body, const Vec3& force);

  /// Computes the poses that follow from the current joint and body positions.
  void update_poses();
  /// Simulates one time step of the model. Returns nullopt, or the problem that occurred: invalid
  /// or huge numbers, after which the engine silently starts again from its initial state, or
  /// omitted contacts. Throws EngineError if the engine failed. In both cases the state is invalid.
  std::optional<std::string> step();
  /// Overwrites `out` with the contacts of the last step that exert forces.
  void contacts(std::vector<GeomContact>& out) const;

  /// Returns the complete state.
  Snapshot snapshot() const;
  /// Restores a complete state. update_poses() or step() must follow before poses are read.
  void restore(const Snapshot& snapshot);

 private:
  struct Running;
  const Model* model_;
  std::unique_ptr<Running> running_;
};

}  // namespace morphe::physics
