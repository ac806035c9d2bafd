#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/enum_names.hpp"
#include "stages/simulate/grasp_command.hpp"
#include "stages/simulate/mjcf_text.hpp"
#include "stages/simulate/servo_commands.hpp"

namespace morphe::simulate {

/// The reason for which a target was not held. Before the lift: the robot was far from its
/// trajectory and a failure resulted; the target was moved too far before the hand closed or while
/// it closed; the target was not touched, or no two fingers press against each other. During the
/// load: a finger's motor was at its limit; the target slid along the fingers, turned about the
/// line between them, or rolled on them; the fingers yielded; no finger touches the target any
/// more. At any time: the engine failed.
enum class Failure {
  none,
  tracking_error,
  displaced_before_closing,
  no_touch,
  no_opposing_contacts,
  displaced_while_closing,
  torque_limit,
  slip,
  pivot,
  roll,
  droop,
  contact_lost,
  engine_error
};
/// Returns true if the hand had grasped the target, so that it was loaded.
constexpr bool reached_load_test(Failure failure) {
  return failure == Failure::none ||
         (failure >= Failure::torque_limit && failure != Failure::engine_error);
}
constexpr std::array<std::string_view, 13> names_of(Failure) {
  return {"none",
          "tracking_error",
          "displaced_before_closing",
          "no_touch",
          "no_opposing_contacts",
          "displaced_while_closing",
          "torque_limit",
          "slip",
          "pivot",
          "roll",
          "droop",
          "contact_lost",
          "engine_error"};
}

/// The displacement of the target's centre, and its rotation.
struct Displacement {
  double distance_m = 0, angle_deg = 0;
};

/// The result of holding a target under a load.
struct HoldResult {
  Failure failure = Failure::none;
  std::string detail;                 ///< message of the engine
  Displacement droop;                 ///< in the palm's frame, until one second after the full load
  Displacement drift;                 ///< largest displacement after that
  Displacement in_hand_displacement;  ///< largest displacement in total, in the palm's frame
  double slip_m = 0;                  ///< largest slip along a finger that touched the target
  /// for this load (force_prediction.hpp); infinite if no squeeze suffices [N]
  double required_force_N = 0;
  /// Returns true if the target was held.
  bool is_held() const { return failure == Failure::none; }
};

/// The result of one rollout.
struct Rollout {
  Variation variation;
  /// largest tracking error of the planned trajectory until the first touch [degrees or mm]
  double arm_error = 0, hand_error = 0;
  /// time of the first contact between robot and target, from the trajectory's start [s]; NaN if
  /// they do not touch
  double contact_s = 0;
  /// largest displacement of the target in the base's frame until it is squeezed
  Displacement pregrasp_displacement;
  double torque_ratio = 0;  ///< largest ratio of a motor's torque to its limit
  /// predicted forces, see force_prediction.hpp
  double commanded_force_N = 0, required_force_gravity_N = 0, required_force_worst_N = 0;
  /// [finger_forces] measured normal force, summed over all capsules of the finger's last link,
  /// once squeezed
  std::vector<double> measured_force_N;
  HoldResult lift;
  /// along the target's -x, x, -y, y, -z, z; empty if not tested
  std::vector<HoldResult> load_directions;
  /// Returns the prediction: true if the commanded squeeze supports the load.
  bool predicts_hold(const HoldResult& load) const {
    return load.required_force_N <= commanded_force_N;
  }
};

/// A plan that has been prepared for any number of rollouts.
struct PreparedPlan {
  const robot::Robot* robot = nullptr;
  SimulatedWorld world;
  GraspCommand squeeze;
  ServoCommands program;  ///< the commands of the controller
  Pose base_from_target = Pose::Identity();
  /// like Rollout::contact_s, for the planned trajectory and closing
  double planned_contact_s = 0;
};

/// Runs the test protocol once (docs/steps/simulate.md). The same arguments give bit-identical
/// results.
Rollout roll_out(const PreparedPlan& plan, const Variation& variation,
                 const SimulateOptions& options, bool directions);

}  // namespace morphe::simulate
