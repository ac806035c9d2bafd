#pragma once

#include "stages/segment/segment_options.hpp"
#include "stages/segment/signals.hpp"

namespace morphe::segment {

/// An interval of motion between two rests or two deep dips of the speed.
struct MovementUnit {
  int first = 0, last = 0;  ///< slowest frames before and after the motion
  int peak = 0;             ///< frame of the highest speed
  /// Peaks of the first and the last of the parts that were merged; `peak` if there is one part.
  int first_peak = 0, last_peak = 0;
  double begin_s = 0, end_s = 0;  ///< times at which the speed passes onset_share of the peak
  double begin_confidence = 1, end_confidence = 1;  ///< of these times, 0 … 1
  /// True if the recording begins or ends inside the unit.
  bool begin_truncated = false, end_truncated = false;
  Vec3 start_position = Vec3::Zero(), end_position = Vec3::Zero();  ///< at begin_s and end_s [m]
  double extent = 0;  ///< largest distance from `start_position` [m]
  /// True if it travels less than weak_unit_share of the farthest of its neighbours, is slower than
  /// min_peak_speed throughout, or only the fingers move.
  bool weak = false;

  Vec3 displacement() const { return end_position - start_position; }  ///< from start to end [m]
};

/// Returns the slowest or fastest frame of `first` … `last`, the first of several.
int slowest_frame(const HandSignals& signals, int first, int last);
int fastest_frame(const HandSignals& signals, int first, int last);

/// Computes begin and end of a unit and all that follows from them, except `weak`, from its
/// `first`, `last`, `peak`, `first_peak` and `last_peak`.
void find_boundaries(const HandSignals& signals, const SegmentOptions& options, MovementUnit& unit);

/// Merges `other`, an adjacent unit, into `unit`, and finds the boundaries of the whole.
void merge_unit(const HandSignals& signals, const SegmentOptions& options,
                const MovementUnit& other, MovementUnit& unit);

}  // namespace morphe::segment
