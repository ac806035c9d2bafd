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
  std::string value;  ///< "" if the data do not determine it
  Confidence confidence = Confidence::guessed;
  std::string reason;  ///< half a sentence
};

/// Guesses the recorded axes that point right, forward and up, as in Conventions::axes: of the 24
/// right-handed choices the one that agrees best with the cues of trunk and arms (body_cues.hpp).
Guess guess_axes(const RecordedPoints& points);

/// Guesses the unit of length, as in Conventions::unit: the one of mm, cm, m, in and ft with which
/// upper arm, forearm, shoulders and hand have usual lengths; if none fits, metres per unit as a
/// number. Without such lengths, it is the one of mm, cm and m that fits the extent of all points.
Guess guess_unit(const RecordedPoints& points);

/// Guesses the frames per second: the usual rate with which the fastest points of 5 % of the frames
/// exceed 1 m/s. Times are not used; `unit_m` is the length of one recorded unit [m].
Guess guess_rate(const RecordedPoints& points, double unit_m);

}  // namespace morphe::imports
