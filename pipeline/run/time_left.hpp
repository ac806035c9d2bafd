#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace morphe::run {

/// What a run's time is told from.
struct WorkSoFar {
  double finished_s = 0;       ///< that the finished ones took, together
  std::int64_t finished = 0;   ///< by this run
  std::vector<double> ages_s;  ///< of those in hand
  std::int64_t waiting = 0;    ///< not begun
  int jobs = 1;
};

/// Seconds that one takes: the mean of the finished ones and of those in hand that have taken
/// longer already. NaN before one is finished.
double seconds_each(const WorkSoFar& work);

/// Seconds until all are finished if each takes seconds_each(); at least as long as the youngest in
/// hand still needs. NaN before one is finished.
double time_left_s(const WorkSoFar& work);

/// "14 s", "5 min", "1.5 h".
std::string duration_text(double seconds);

}  // namespace morphe::run
