#pragma once

#include <optional>
#include <vector>

#include "core/motion/robot_model.hpp"
#include "core/physics/model.hpp"
#include "core/physics/state.hpp"
#include "stages/simulate/hold_result.hpp"

namespace morphe::simulate {

/// The engine's indices of a model's parts.
struct ModelIds {
  ModelIds(const physics::Model& model, const RobotModel& robot, bool lifts_base);

  int target_body = 0, target_geom = 0, palm_body = 0;
  int base_motor = -1;               ///< -1 if the base is fixed
  std::vector<int> bodies, joints;   ///< [frames] joints: -1 for a fixed frame
  std::vector<int> motors;           ///< [joints]
  std::vector<int> capsule_of_geom;  ///< [geoms] -1 if the geom is not a capsule
};

/// A contact of a capsule with the target.
struct TargetContact {
  int capsule = 0;
  Vec3 point, inward;  ///< in the world's frame; unit, into the target
  double force_N = 0;  ///< along `inward`
};
/// Returns the contacts of the last step. `touches` is a scratch buffer.
std::vector<TargetContact> target_contacts(const physics::State& state, const ModelIds& parts,
                                           std::vector<physics::GeomContact>& touches);
/// Returns true if two of the contacts press against each other.
bool has_opposing_contacts(const std::vector<TargetContact>& contacts);

/// Returns the pose of the target in the palm's frame.
Pose palm_from_target(const physics::State& state, const ModelIds& parts);
/// Returns the displacement of a body between two poses.
Displacement displacement_between(const Pose& from, const Pose& to);
/// Raises distance and angle of `maximum` to those of a displacement.
void update_maximum(const Displacement& displacement, Displacement& maximum);

/// Monitors a target that is to be held, from the squeezed state on.
class HoldMonitor {
 public:
  /// The motion after the droop is limited unless the target is carried about.
  HoldMonitor(const RobotModel& robot, const ModelIds& parts, const physics::State& squeezed,
              bool limits_drift = true);
  /// Evaluates a state. `settled` is true once the droop is over, after which the target must not
  /// move; `at_limit` is true if a finger's motor is at its torque limit.
  void update(const physics::State& state, bool settled, bool at_limit);
  /// Returns true once the target has moved too far; later states are irrelevant.
  bool failed() const { return !result_.is_held(); }
  /// Returns the result so far. Without opposing contacts in the last state, contact is lost.
  HoldResult result() const;

 private:
  /// A point of contact, fixed in the frame of the target and in that of the finger's link.
  struct ContactAnchor {
    int frame;
    Vec3 on_target, on_finger;
  };
  /// Returns the cause of the target's motion in the palm: a motor's limit, lost contact, or by
  /// whether its rotation or its translation is larger relative to its limit.
  Failure classify_failure(const Pose& from, const Pose& palm_from_target) const;

  const RobotModel& robot_;
  const ModelIds& parts_;
  const bool limits_drift_;
  Pose start_;       ///< palm_from_target
  Vec3 grasp_axis_;  ///< unit, in the palm's frame
  std::vector<ContactAnchor> anchors_;
  std::optional<Pose> settled_;
  std::vector<TargetContact> contacts_;
  std::vector<physics::GeomContact> touches_;
  bool at_limit_ = false;
  Failure first_cause_ = Failure::none;
  HoldResult result_;
};

}  // namespace morphe::simulate
