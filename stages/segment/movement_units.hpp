#pragma once

#include <cstddef>
#include <vector>

#include "stages/segment/segment_options.hpp"
#include "stages/segment/signals.hpp"

namespace morphe::segment {

/// An interval of motion between two rests or two deep dips of the speed.
struct MovementUnit {
  std::size_t first = 0, last = 0;            ///< frames of the slowest points before and after
  std::size_t peak = 0;                       ///< frame of the highest speed
  std::size_t first_peak = 0, last_peak = 0;  ///< fastest frames of the outermost parts
  double begin_s = 0, end_s = 0;  ///< times at which the speed passes onset_share of the peak
  /// Confidences of start and end, 0 … 1.
  double begin_confidence = 1, end_confidence = 1;
  /// True if the recording begins or ends inside the unit.
  bool begin_truncated = false, end_truncated = false;
  Vec3 start_position = Vec3::Zero(),
       end_position = Vec3::Zero();  ///< positions of the hand at begin_s and end_s [m]
  double extent = 0;                 ///< largest distance from `start_position` [m]
  /// True if it travels less than weak_bout_share of the farthest of its neighbours, or only the
  /// fingers move.
  bool weak = false;
};

/// Returns the movement units of a recording in order. Two speed peaks form two units if the dip
/// between them is deep for the change of direction of the hand: v_dip / v_smaller_peak < dip_share
/// (1 − cos θ), within 0.15 … dip_share, with θ the angle between the displacements before and
/// after the dip; a correction on the way must come to a stop to count. `splits_s` are times at
/// which other evidence (an object that starts or stops to move) indicates the end of a unit, which
/// is cut at the slowest frame nearby. Peaks below four times the noise are ignored. No threshold
/// depends on the speed of other units.
///
/// A weak unit beside a stronger one is merged with it if the speed between them never falls to the
/// level at which the stronger one ends, or only for 0.1 s and the weak one is faster than
/// `weak_bout_share` of the stronger peak: a hand that closes as it arrives, or lets go as it sets
/// out. Slower closing and letting go is detected from the fingers (finger_motion.hpp).
std::vector<MovementUnit> find_movement_units(const HandSignals& signals,
                                              const SegmentOptions& options,
                                              const std::vector<double>& splits_s);

/// Least ratio of a speed peak to the rms of the noise.
inline constexpr double kMinPeakNoiseRatio = 4;

/// Computes the start and end of a unit between `first` and `last`, and the values that follow from
/// them.
void find_boundaries(const HandSignals& signals, const SegmentOptions& options, MovementUnit& bout);

/// Merges `other`, an adjacent unit, into `bout`. Start and end are those of the merged unit.
void merge_unit(const HandSignals& signals, const SegmentOptions& options,
                const MovementUnit& other, MovementUnit& bout);

/// Returns 1 − slowest / (dip_share · smaller_peak), clamped to 0 … 1.
double dip_confidence(double slowest, double smaller_peak, double dip_share);

}  // namespace morphe::segment
