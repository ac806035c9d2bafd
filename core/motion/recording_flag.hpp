#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/enum_names.hpp"
#include "core/motion/geometry.hpp"

namespace morphe {

/// A doubt about a recording, or about a movement of it; docs/audit.md has the measure and the
/// limit of each.
enum class FlagCode : std::uint8_t {
  exchanged_markers,    ///< markers carry each other's names
  exchanged_digits,     ///< the tips of thumb and index finger carry each other's names
  mirrored,             ///< the body is the mirror image of a human one, or the hand the other one
  spike,                ///< a point jumps away and returns
  step,                 ///< a point jumps away and stays there
  frozen_rows,          ///< consecutive rows are equal
  repeated_rows,        ///< rows are written more than once
  lost_rows,            ///< all points jump at once: rows are missing
  time_base,            ///< the speeds are not those of a person: the rate is wrong
  vertical,             ///< the person does not stand or sit upright
  scale,                ///< the body does not have the size of a person
  static_trial,         ///< the static trial is not that of the recording
  jitter,               ///< the points tremble
  target_away,          ///< the fingers close far from the target
  missing_goals,        ///< too many of the goals in the grasp were not recorded
  incomplete_movement,  ///< the movement begins or ends in motion at the edge of the recording
  no_grasp,             ///< the task takes an object, but no grasp was found
  unlikely_target,      ///< the target that is inferred would have a size that no hand grasps
  target_offset,        ///< the fingers close beside the target as it was recorded
  object_away,          ///< a recorded object is nowhere near the hand
};
/// Returns the names of the values, in their order.
constexpr std::array<std::string_view, 20> names_of(FlagCode) {
  // clang-format off
  return {"exchanged_markers", "exchanged_digits", "mirrored", "spike", "step", "frozen_rows",
          "repeated_rows", "lost_rows", "time_base", "vertical", "scale", "static_trial", "jitter",
          "target_away", "missing_goals", "incomplete_movement", "no_grasp",
          "unlikely_target", "target_offset", "object_away"};
  // clang-format on
}

/// The answer to a doubt: the data were mended; the doubt was only flagged; or a manifest accepts
/// it, and the data are unchanged.
enum class FlagResponse : std::uint8_t { mended, flagged, accepted };
/// Returns the names of the values, in their order.
constexpr std::array<std::string_view, 3> names_of(FlagResponse) {
  return {"mended", "flagged", "accepted"};
}

/// A doubt about a recording, with its place and its measure.
struct RecordingFlag {
  FlagCode code = FlagCode::spike;
  FlagResponse response = FlagResponse::flagged;
  /// First and last moment concerned, in the recording's time [s]; NaN for all of it.
  double begin_s = kUnknown, end_s = kUnknown;
  std::string subject = {};  ///< marker, joint or object, or ""
  double value = kUnknown;   ///< the measure [unit]
  double limit = kUnknown;   ///< that it exceeds, or falls short of [unit]
  std::string unit = {};     ///< "m", "m/s", "1", … of both
  std::string text = {};     ///< a sentence for the user, without a full stop

  /// Returns true if the flag concerns a moment between these.
  bool overlaps(double from_s, double to_s) const { return !(end_s < from_s) && !(begin_s > to_s); }
};

/// A code that the user accepts for a recording, having looked at it.
struct AcceptedFlag {
  FlagCode code = FlagCode::spike;
};

}  // namespace morphe
