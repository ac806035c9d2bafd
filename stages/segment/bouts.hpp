#pragma once

#include <cstddef>
#include <vector>

#include "stages/segment/segment_options.hpp"
#include "stages/segment/signals.hpp"

namespace morphe::segment {

/// An interval of motion between two rests or two deep dips of speed.
struct Bout {
  std::size_t first = 0, last = 0;  ///< frames from the slowest point before to that after
  std::size_t peak = 0;             ///< its fastest frame
  std::size_t first_part = 0, last_part = 0;  ///< fastest frames of its outermost parts
  double begin_s = 0, end_s = 0;  ///< where its speed passes onset_share of its own peak
  double begin_confidence = 1, end_confidence = 1;
  bool cut_begin = false, cut_end = false;      ///< the recording begins or ends inside it
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  ///< where the hand was at begin_s and end_s [m]
  double extent = 0;                            ///< farthest from `from` [m]
  /// Goes less than weak_share of the farthest of its neighbours', or only the fingers move.
  bool weak = false;
};

/// Bouts in order. Two peaks of speed are two bouts if the dip between them is deep for the turn
/// that the hand takes there: v_dip / v_smaller_peak < dip_share (1 − cos θ), within 0.15 …
/// dip_share, with θ between the ways on its sides: a correction on the way has to come to a stop
/// to count. `splits_s` are times at which something else (an object that
/// starts or stops to move) says that a bout ends; it is cut at the slowest frame nearby. Peaks
/// below four times the noise are none. No threshold hangs on the speed of other bouts.
///
/// A weak bout beside a stronger one belongs to it if the speed between them never falls to the
/// level at which the stronger one is over, or only for 0.1 s and the weak one is faster than
/// `weak_share` of its peak: a hand that closes as it arrives, or lets go as it sets out. Slower
/// closing and letting go is known by the fingers (fingers.hpp).
std::vector<Bout> find_bouts(const HandSignals& signals, const SegmentOptions& options,
                             const std::vector<double>& splits_s);

/// What is slower than this many times the rms of noise is not told from it.
inline constexpr double kNoisePeak = 4;

/// Begin, end and what follows from them, of a bout between `first` and `last`.
void find_ends(const HandSignals& signals, const SegmentOptions& options, Bout& bout);

/// Lengthens a bout by one beside it: its begin and end are those of the two taken as one.
void absorb(const HandSignals& signals, const SegmentOptions& options, const Bout& other,
            Bout& bout);

/// 1 − slowest / (dip_share · smaller_peak) within 0 … 1.
double dip_confidence(double slowest, double smaller_peak, double dip_share);

}  // namespace morphe::segment
