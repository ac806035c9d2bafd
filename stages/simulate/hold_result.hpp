#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/motion/enum_names.hpp"

namespace morphe::simulate {

/// The reason for which a target was not held.
/// Before the lift, the target was moved too far before the hand closed or while it closed, was not
/// touched, or no two fingers press against each other; any of these is a tracking_error if the
/// robot was far from its trajectory.
/// Under load, a finger's motor was at its limit; the target slid along the fingers, turned about
/// the line between them (pivot), or rolled on them; the fingers yielded (droop); or no two fingers
/// press against each other any more (contact_lost).
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
/// Returns true if the hand had grasped the target, so that it was loaded.
constexpr bool reached_load_test(Failure failure) {
  return failure == Failure::none ||
         (failure >= Failure::torque_limit && failure != Failure::engine_error);
}

/// The displacement of the target's centre, and its rotation.
struct Displacement {
  double distance_m = 0, angle_deg = 0;
};

/// The result of holding a target under a load.
struct HoldResult {
  Failure failure = Failure::none;
  std::string detail;                 ///< message of the engine; "" without an engine_error
  Displacement droop;                 ///< in the palm's frame, until one second after the full load
  Displacement drift;                 ///< largest displacement after that
  Displacement in_hand_displacement;  ///< largest displacement in total, in the palm's frame
  double slip_m = 0;                  ///< largest slip along a finger that touched the target
  double required_force_N = 0;  ///< by statics (RequiredForces); infinite if no force suffices
  /// Returns true if the target was held.
  bool is_held() const { return failure == Failure::none; }
};

}  // namespace morphe::simulate
