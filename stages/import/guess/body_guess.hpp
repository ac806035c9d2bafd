#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/motion/named.hpp"
#include "stages/import/guess/recorded_points.hpp"

namespace morphe::imports {

enum class Sureness : std::uint8_t { guessed, likely, sure };
constexpr std::array<std::string_view, 3> names_of(Sureness) {
  return {"a guess", "likely", "sure"};
}

/// A value that was computed from the data, how sure it is, and from what.
struct Guess {
  std::string value;  ///< "" = nothing to go by
  Sureness sure = Sureness::guessed;
  std::string because;  ///< half a sentence
};

/// Which recorded axes point right, forward and up, as Conventions::axes: of the 24 right-handed
/// choices the one that agrees best with the body (from left to right shoulder or hip, from hips to
/// shoulders and head, from ankle to toe), and, weaker, with how an arm is held and reaches: the
/// elbow below and outside of the shoulder, the hand in front of it, along a table.
Guess guess_axes(const RecordedPoints& points);

/// Metres in one recorded unit, as Conventions::unit: the one of mm, cm, m and in with which upper
/// arm, forearm, shoulders and hand have usual lengths; a number where none has them. From the
/// extent of all points where no such length can be told.
Guess guess_unit(const RecordedPoints& points);

/// Frames a second of a recording read at 1 Hz: a usual rate at which the hand, where it is
/// fastest, moves as fast as in a reach. `unit_m` metres in one recorded unit.
Guess guess_rate(const RecordedPoints& points, double unit_m);

}  // namespace morphe::imports
