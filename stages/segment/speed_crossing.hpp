#pragma once

#include <cstddef>

#include "stages/segment/signals.hpp"

namespace morphe::segment {

/// The crossing of a level by a rise or fall of the speed.
struct SpeedCrossing {
  double frame = 0;      ///< fractional frame of the crossing
  double time_sd_s = 0;  ///< standard deviation caused by the noise: noise over slope
};

/// Finds the crossing from frame `peak` towards frame `rest` (before it for an onset, after it for
/// an end) beyond which the speed stays below `level` [m/s]; parts faster than `part` that follow
/// within 0.1 s belong to the motion. Returns `rest` itself if the speed never falls so far.
///
/// If the level is below the noise, it is extrapolated from the flank above the noise: a
/// minimum-jerk rise v(τ) = 16 p τ²(1 − τ)² gives τ = (1 − √(1 − √(v/p))) / 2, a straight line over
/// time, fitted by least squares. Other smooth rises are nearly straight over those few frames.
SpeedCrossing find_speed_crossing(const HandSignals& signals, std::size_t rest, std::size_t peak,
                                  double level, double part);

}  // namespace morphe::segment
