#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/motion/enum_names.hpp"
#include "core/motion/geometry.hpp"

namespace morphe::simulate {

/// The reason for which a target was not held.
/// Before the lift, the target was moved too far before the hand closed or while it closed, was not
/// touched, or no two fingers press against each other; any of these is a tracking_error if the
/// robot was far from its trajectory.
/// Under load, a finger's motor was at its limit; the target slid along the fingers, turned about
/// the line between them (pivot), or rolled on them; the fingers yielded (droop); or no two fingers
/// press against each other any more (contact_lost).
/// A target that is carried as planned was not lifted, or it was not put down: it is too far from
/// its planned place, in the hand (misplaced) or since the hand let go of it or left it; its
/// vertical is tilted; the hand still touches it (not_released); or it does not stand still.
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
  not_lifted,
  misplaced,
  displaced_while_releasing,
  displaced_while_leaving,
  tilted,
  not_released,
  still_moving,
  engine_error
};
constexpr std::array<std::string_view, 20> names_of(Failure) {
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
          "not_lifted",
          "misplaced",
          "displaced_while_releasing",
          "displaced_while_leaving",
          "tilted",
          "not_released",
          "still_moving",
          "engine_error"};
}
/// Returns true if the hand had grasped the target, so that it was loaded.
constexpr bool reached_load_test(Failure failure) {
  return failure == Failure::none ||
         (failure >= Failure::torque_limit && failure != Failure::engine_error);
}

/// The forecast of a hold from the ratio of the commanded to the required force: from
/// kForecastMargin on it holds, below its inverse it falls, and in between it is near its limit.
enum class Forecast { falls, near_limit, holds };
constexpr std::array<std::string_view, 3> names_of(Forecast) {
  return {"falls", "near_limit", "holds"};
}
/// Chosen by hand. Statics leaves out that fingers yield and that a turn of the target spends
/// friction: of the lifts with ratios from 1 to 1.15, 14 % are held, up to 1.3 about half, from 2
/// on 99 % (the study is in docs/steps/simulate.md).
inline constexpr double kForecastMargin = 1.15;
/// Returns the forecast for a required force, which may be infinite, and a commanded one [N].
constexpr Forecast forecast_of(double required_N, double commanded_N) {
  if (commanded_N >= kForecastMargin * required_N) return Forecast::holds;
  return kForecastMargin * commanded_N >= required_N ? Forecast::near_limit : Forecast::falls;
}

/// The displacement of the target's centre, and its rotation.
struct Displacement {
  double distance_m = 0, angle_deg = 0;
};

/// The result of holding a target under a load.
struct HoldResult {
  Failure failure = Failure::none;
  std::string detail;  ///< message of the engine; "" without an engine_error
  /// in the palm's frame, until one second after the full load, or after the begin of carrying
  Displacement droop;
  Displacement drift;                 ///< largest displacement after that
  Displacement in_hand_displacement;  ///< largest displacement in total, in the palm's frame
  double slip_m = 0;                  ///< largest slip along a finger that touched the target
  double required_force_N = 0;  ///< by statics (RequiredForces); infinite if no force suffices
  /// Returns true if the target was held.
  bool is_held() const { return failure == Failure::none; }
};

/// A displacement that was not measured.
inline constexpr Displacement kNotMeasured{kUnknown, kUnknown};

/// The result of executing a plan that carries its target; NaN for what was not reached.
struct TaskResult {
  Failure failure = Failure::none;          ///< first cause; of the grasp or hold, if it failed
  double rise_m = kUnknown;                 ///< greatest rise of the target's lowest point
  Displacement palm_offset = kNotMeasured;  ///< largest from the planned pose in the palm, carried
  double arm_error = kUnknown;              ///< largest while carrying [degrees or mm]
  Displacement carried_error = kNotMeasured;  ///< from the planned place, at the release
  Displacement place_error = kNotMeasured;    ///< from the planned place, at the end
  double tilt_deg = kUnknown;                 ///< of its vertical from the planned one, at the end
  Displacement standing_motion = kNotMeasured;  ///< after the end of the trajectory
  /// Returns true if the target was lifted, carried, put down and let go as planned.
  bool is_done() const { return failure == Failure::none; }
};

}  // namespace morphe::simulate
