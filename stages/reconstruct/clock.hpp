#pragma once

#include <cstddef>
#include <vector>

#include "core/motion/geometry.hpp"
#include "stages/reconstruct/reconstruct.hpp"

namespace morphe::reconstruct {

/// Instants start_s + i / rate_hz, i = 0 … count - 1.
struct Clock {
  double start_s = 0, rate_hz = 100;
  std::size_t count = 0;
  double at(std::size_t i) const { return start_s + static_cast<double>(i) / rate_hz; }
};

/// From the first to the last instant of any of the streams' times (each sorted); none if that is
/// more than memory holds.
Clock clock_over(const std::vector<const std::vector<double>*>& stream_times, double rate_hz);

/// A recorded signal on the clock: a natural cubic spline through the seen samples, which bridges
/// gaps up to max_gap_s, low-passed run by run (at a multiple of the clock's rate if the stream is
/// faster). NaN inside longer gaps and outside the recording. `time` is strictly increasing.
std::vector<double> on_clock(const std::vector<double>& time, const std::vector<double>& values,
                             const Clock& clock, const ReconstructOptions& options);
std::vector<Vec3> on_clock(const std::vector<double>& time, const std::vector<Vec3>& values,
                           const Clock& clock, const ReconstructOptions& options);
/// Component-wise after giving neighbours the same sign, then normalised: for rotations that turn
/// little within the filter's memory.
std::vector<Quat> on_clock(const std::vector<double>& time, const std::vector<Quat>& values,
                           const Clock& clock, const ReconstructOptions& options);

}  // namespace morphe::reconstruct
