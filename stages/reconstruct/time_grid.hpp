#pragma once

#include <cstddef>
#include <vector>

#include "core/motion/geometry.hpp"
#include "stages/reconstruct/reconstruct.hpp"

namespace morphe::reconstruct {

/// The instants start_s + i / rate_hz, i = 0 … count - 1.
struct TimeGrid {
  double start_s = 0, rate_hz = 100;  ///< first instant and rate
  std::size_t count = 0;              ///< number of instants
  /// Returns instant i [s].
  double at(std::size_t i) const { return start_s + static_cast<double>(i) / rate_hz; }
};

/// Creates the grid from the first to the last instant of all the streams' times (each sorted); it
/// is empty if that exceeds the memory.
TimeGrid make_time_grid(const std::vector<const std::vector<double>*>& stream_times,
                        double rate_hz);

/// Resamples a recorded signal on the clock by a natural cubic spline through the seen samples,
/// which bridges gaps up to max_gap_s and is low-passed run by run (at a multiple of the clock's
/// rate if the stream is faster). NaN inside longer gaps and outside the recording. `time` must be
/// strictly increasing.
std::vector<double> resample(const std::vector<double>& time, const std::vector<double>& values,
                             const TimeGrid& clock, const ReconstructOptions& options);
std::vector<Vec3> resample(const std::vector<double>& time, const std::vector<Vec3>& values,
                           const TimeGrid& clock, const ReconstructOptions& options);
/// Resamples component by component after giving neighbours the same sign, then normalises: for
/// orientations that change little within the filter's memory.
std::vector<Quat> resample(const std::vector<double>& time, const std::vector<Quat>& values,
                           const TimeGrid& clock, const ReconstructOptions& options);

}  // namespace morphe::reconstruct
