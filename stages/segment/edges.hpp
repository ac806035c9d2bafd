#pragma once

#include <cstddef>

#include "stages/segment/signals.hpp"

namespace morphe::segment {

/// Where a rise or fall of speed passes a level.
struct Edge {
  double frame = 0;     ///< fractional
  double spread_s = 0;  ///< by how much the noise may have moved it: noise over slope
};

/// Going from frame `peak` to frame `rest` (before it: an onset, behind it: an end), where the
/// speed falls below `level` [m/s] for good: parts faster than `part` that follow within 0.1 s
/// belong to what came before. `rest` itself if it never falls so far.
///
/// Where the level drowns in noise, it is extrapolated from the flank above the noise: a
/// minimum-jerk rise v(τ) = 16 p τ²(1 − τ)² gives τ = (1 − √(1 − √(v/p))) / 2, a straight line over
/// time, fitted by least squares. Other smooth rises are nearly straight over those few frames.
Edge find_edge(const HandSignals& signals, std::size_t rest, std::size_t peak, double level,
               double part);

}  // namespace morphe::segment
