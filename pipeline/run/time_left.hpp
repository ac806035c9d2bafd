#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace morphe::run {

/// The numbers from which the remaining time of a run is estimated.
struct RunWorkload {
  double finished_total_s = 0;  ///< sum of the durations of the finished demonstrations
  std::int64_t finished = 0;    ///< demonstrations that this run has finished
  std::vector<double> ages_s;   ///< time since the start of each running demonstration
  std::int64_t waiting = 0;     ///< demonstrations that have not started
  int jobs = 1;                 ///< number of threads
};

/// Returns the expected duration of a demonstration [s]: the mean over the finished ones and those
/// running ones that have already taken longer than these on average. NaN before one is finished.
double seconds_per_demonstration(const RunWorkload& work);

/// Returns max(sum of the remaining times / jobs, longest remaining time of a running one) [s], if
/// each demonstration takes the expected duration; NaN before one is finished.
double time_left_s(const RunWorkload& work);

/// Formats a duration: "14 s", "5 min", "1.5 h".
std::string duration_text(double seconds);

}  // namespace morphe::run
