#pragma once

#include <cstddef>

#include "stages/segment/signals.hpp"

namespace morphe {

/// Where a rise or fall of speed passes a share of its peak.
struct Edge {
  double frame = 0;     ///< fractional
  double spread_s = 0;  ///< by how much the noise may have moved it: noise over slope
};

/// The edge between frame `rest` (slow) and frame `peak` of a bout: its onset if rest < peak, its
/// end if rest > peak. Beyond the last part that is faster than `weak_share` of the peak, it is
/// where the speed passes `level` share of the peak; `rest` itself if it never falls so far.
///
/// Where the level drowns in noise, it is extrapolated from the flank above the noise: a
/// minimum-jerk rise v(τ) = 16 p τ²(1 − τ)² gives τ = (1 − √(1 − √(v/p))) / 2, a straight line over
/// time, fitted by least squares. Other smooth rises are nearly straight over those few frames.
Edge find_edge(const HandSignals& signals, std::size_t rest, std::size_t peak, double level,
               double weak_share);

}  // namespace morphe
