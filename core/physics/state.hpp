#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/geometry.hpp"
#include "core/physics/model.hpp"

namespace morphe::physics {

/// All that goes on from one step to the next: a state that is given it goes on bit for bit as the
/// one it was taken from. It fits every model with the same bodies, joints and actuators.
struct Snapshot {
  double time_s = 0;
  std::vector<double> position, velocity, control;
  std::vector<double> acceleration;  ///< where the solver begins its next search
};

/// Two geoms that touch.
struct Touch {
  int first = 0, second = 0;  ///< geoms
  Vec3 point, normal;         ///< unit, from the first to the second
  double distance = 0;        ///< < 0: how deep they lie in each other [m]
  double force = 0;           ///< along the normal [N]
};

/// One simulation of a model, which must outlive it; a thread's own. All poses are in the world's
/// frame. After a step bodies and touches are as it began, joints as it ended. Motors carry what
/// gravity, the robot's own motion and the accelerations that were set ask of every joint but free
/// ones (inverse dynamics), beside what their servos ask.
class State {
 public:
  explicit State(const Model& model);
  ~State();
  State(State&&) noexcept;

  double time_s() const;
  void set_joint(int joint, double value);
  double joint(int joint) const;
  /// Of a body that hangs on nothing; at rest.
  void set_body(int body, const Pose& pose);
  Pose body(int body) const;
  void set_control(int actuator, double value);
  /// Which acceleration of a joint its motor is to carry, until it is changed: 0 at first
  /// [rad/s^2 or m/s^2].
  void set_acceleration(int joint, double value);
  /// What the servo asks before the motor's limit, and all that the motor gives: servo within its
  /// limit and the compensation [N m or N]. Of the last step.
  double asked(int actuator) const;
  double given(int actuator) const;
  /// A force on a body's centre of mass, until it is changed [N].
  void push(int body, const Vec3& force);

  /// Poses that follow from joints and bodies as they were set.
  void pose();
  /// One step of the model's length. Nothing, or what went wrong: numbers that are none or huge,
  /// contacts that were left out. The engine goes on from its start then, silently: what this state
  /// says from here on means nothing. EngineError: the engine gave up, the same holds.
  std::optional<std::string> step();
  /// Of the last step.
  void touches(std::vector<Touch>& out) const;

  Snapshot snapshot() const;
  void restore(const Snapshot& snapshot);

 private:
  struct Running;
  const Model* model_;
  std::unique_ptr<Running> running_;
};

}  // namespace morphe::physics
