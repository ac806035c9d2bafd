#pragma once

#include "stages/segment/signals.hpp"

namespace morphe::segment {

/// The crossing of a level by a rise or fall of the speed.
struct SpeedCrossing {
  double frame = 0;      ///< fractional frame of the crossing
  double time_sd_s = 0;  ///< its standard deviation [s]: noise over slope of the speed
};

/// Finds the frame at which a motion begins or ends. The search goes from frame `peak` of the
/// motion to frame `rest` (before `peak` for the begin, after it for the end), up to the crossing
/// beyond which the speed stays below `level` [m/s]. Of the motion beyond, parts that exceed
/// `min_part_speed` [m/s] within 0.1 s are included. Returns `rest` if the speed never falls so
/// far.
///
/// A level below the noise is extrapolated from the flank above the noise. A minimum-jerk rise v(τ)
/// = 16 p τ²(1 − τ)² with peak p has τ = (1 − √(1 − √(v/p))) / 2, a straight line over time, which
/// is fitted by least squares. Other smooth rises are nearly straight over those few frames.
SpeedCrossing find_speed_crossing(const HandSignals& signals, int rest, int peak, double level,
                                  double min_part_speed);

}  // namespace morphe::segment
