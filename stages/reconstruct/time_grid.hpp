#pragma once

#include <vector>

#include "core/motion/human_motion.hpp"
#include "stages/reconstruct/reconstruct_options.hpp"

namespace morphe::reconstruct {

/// The instants start_s + i / rate_hz, i = 0 … count - 1.
struct TimeGrid {
  double start_s = 0, rate_hz = 100;
  int count = 0;
  /// Returns instant i [s].
  double at(std::ptrdiff_t i) const { return start_s + static_cast<double>(i) / rate_hz; }
};

/// Returns a motion of `clock.count` frames with all quantities unseen.
HumanMotion unseen_motion(const TimeGrid& clock);

/// Returns the grid from the first to the last instant of the streams, whose times [s] increase. It
/// is empty without samples and if it would have 1e8 instants or more.
TimeGrid make_time_grid(const std::vector<const std::vector<double>*>& stream_times,
                        double rate_hz);

/// Resamples a signal at strictly increasing times on the clock. Gaps longer than max_gap_s divide
/// it into runs; each run of two or more seen samples gets a natural cubic spline, which is sampled
/// (at a multiple of the clock's rate if the stream is faster) and low-passed at cutoff_hz. NaN
/// inside these gaps and outside the recording.
std::vector<double> resample(const std::vector<double>& time, const std::vector<double>& values,
                             const TimeGrid& clock, const ReconstructOptions& options);
std::vector<Vec3> resample(const std::vector<double>& time, const std::vector<Vec3>& values,
                           const TimeGrid& clock, const ReconstructOptions& options);
/// Resamples component by component after giving neighbours the same sign, then normalises: for
/// orientations that change little within the filter's memory.
std::vector<Quat> resample(const std::vector<double>& time, const std::vector<Quat>& values,
                           const TimeGrid& clock, const ReconstructOptions& options);

}  // namespace morphe::reconstruct
