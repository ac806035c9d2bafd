#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/motion/enum_names.hpp"
#include "stages/import/guess/recorded_points.hpp"

namespace morphe::imports {

/// The confidence in a guess.
enum class Confidence : std::uint8_t { guessed, likely, sure };
/// Returns the names of the levels.
constexpr std::array<std::string_view, 3> names_of(Confidence) {
  return {"a guess", "likely", "sure"};
}

/// A value that was computed from the data, with its confidence and reason.
struct Guess {
  std::string value;                            ///< "" if the data do not determine it
  Confidence confidence = Confidence::guessed;  ///< confidence in the value
  std::string reason;                           ///< half a sentence
};

/// Guesses the recorded axes that point right, forward and up, as Conventions::axes: among the 24
/// right-handed choices the one that agrees best with the body (from left to right shoulder or hip,
/// from hips to shoulders and head, from ankle to toe), and with lower weight with the posture and
/// reach of an arm: the elbow below and outside of the shoulder, the hand in front of it, along a
/// table.
Guess guess_axes(const RecordedPoints& points);

/// Guesses the length unit in metres, as Conventions::unit: the one of mm, cm, m and in with which
/// upper arm, forearm, shoulders and hand have usual lengths, or a number if there is no such unit.
/// Uses the extent of all points if no such length can be determined.
Guess guess_unit(const RecordedPoints& points);

/// Guesses the number of frames per second of a recording read at 1 Hz: a usual rate at which the
/// hand, at its fastest, has the speed of a reach. `unit_m` is the length in metres of one recorded
/// unit.
Guess guess_rate(const RecordedPoints& points, double unit_m);

}  // namespace morphe::imports
