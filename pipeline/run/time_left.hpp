#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace morphe::run {

/// The numbers from which the remaining time of a run is estimated.
struct RunWorkload {
  /// Total duration of the finished demonstrations [s].
  double finished_total_s = 0;
  /// Number of demonstrations that this run has finished.
  std::int64_t finished = 0;
  /// Time since the start of each running demonstration [s].
  std::vector<double> ages_s;
  /// Number of demonstrations that have not started.
  std::int64_t waiting = 0;
  /// The number of threads.
  int jobs = 1;
};

/// Returns the duration of one demonstration [s]: the mean over the finished ones and over those
/// running ones that have already taken longer. Returns NaN before one is finished.
double seconds_per_demonstration(const RunWorkload& work);

/// Returns the time until all demonstrations are finished [s] if each takes
/// seconds_per_demonstration(). It is at least the time that the youngest running demonstration
/// still needs. Returns NaN before one is finished.
double time_left_s(const RunWorkload& work);

/// Formats a duration: "14 s", "5 min", "1.5 h".
std::string duration_text(double seconds);

}  // namespace morphe::run
