#pragma once

#include <cstddef>
#include <vector>

#include "stages/segment/segment.hpp"
#include "stages/segment/signals.hpp"

namespace morphe {

/// An interval of motion between two rests or two deep dips of speed.
struct Bout {
  std::size_t first = 0, last = 0;  ///< frames inside it
  std::size_t peak = 0;             ///< its fastest frame
  double begin_s = 0, end_s = 0;
  double begin_confidence = 1, end_confidence = 1;
  bool cut = false;  ///< the recording begins inside it
};

/// Bouts in order. An interval above `stop_share` of the peak is cut at its relatively deepest dip
/// as long as that is deeper than `dip_share` of the smaller peak beside it (or nearly a rest).
/// A bout begins at its fitted onset and ends where it falls to rest, or at the dip. Ends are not
/// fitted: a hand homes in on its target in a slow tail that no smooth profile describes.
std::vector<Bout> find_bouts(const HandSignals& signals, const SegmentOptions& options);

/// Onset of a minimum-jerk rise. Speed v(τ) = 16 p τ²(1 − τ)² with τ = (t − t0) / T and peak p
/// gives τ = (1 − √(1 − √(v/p))) / 2: a straight line over time, fitted by least squares to the
/// samples between 3 and 30 % of p, the first peak of [first, last]. Returns the (fractional)
/// frame at which the fitted rise has speed `level` (0: t0), or NaN if fewer than three samples are
/// on it.
double fitted_onset(const std::vector<double>& speed, std::size_t first, std::size_t last,
                    double level);

/// 1 − slowest / (dip_share · smaller_peak) within 0 … 1.
double boundary_confidence(double slowest, double smaller_peak, double dip_share);

}  // namespace morphe
