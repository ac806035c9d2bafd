#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/enum_names.hpp"

namespace morphe {

/// The way in which a plan came by a value that was not measured: it was inferred from the
/// recording; it was assumed without data; it was set by hand, against the config file or the
/// defaults; or no step has looked at it at all.
enum class AssumptionKind : std::uint8_t { inferred, assumed, set_by_hand, not_looked_at };
/// Returns the names of the values, in their order.
constexpr std::array<std::string_view, 4> names_of(AssumptionKind) {
  return {"inferred", "assumed", "set_by_hand", "not_looked_at"};
}

/// The subjects that a config can require to be known (`must_be_known`), by the names that
/// Assumption::subject has.
enum class Knowable : std::uint8_t {
  target,        ///< pose and shape of the object that is grasped
  table,         ///< height of the table
  limits,        ///< the robot's limits of velocity, acceleration and jerk
  mount,         ///< how the hand is mounted on the arm
  geometry,      ///< bodies, fingertips or chains of the robot
  unit,          ///< of the recording
  axes,          ///< of the recording
  rate,          ///< of the recording
  side,          ///< of the hand that was recorded
  static_trial,  ///< which recording is the static trial
};
/// Returns the names of the values, in their order.
constexpr std::array<std::string_view, 10> names_of(Knowable) {
  return {"target", "table", "limits", "mount", "geometry",
          "unit",   "axes",  "rate",   "side",  "static_trial"};
}

/// A value on which a plan depends and which nobody measured.
struct Assumption {
  AssumptionKind kind = AssumptionKind::assumed;
  std::string subject;  ///< the name of a Knowable or another subject, or the key of a setting
  std::string value;    ///< what is taken for it, and why; a phrase without a full stop

  bool operator==(const Assumption&) const = default;
};

}  // namespace morphe
