#include "pipeline/run/time_left.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/motion/geometry.hpp"

namespace morphe::run {

double seconds_per_demonstration(const RunWorkload& work) {
  if (work.finished == 0) return kUnknown;
  const double mean_s = work.finished_total_s / static_cast<double>(work.finished);
  double sum_s = work.finished_total_s;
  auto count = static_cast<double>(work.finished);
  for (const double age_s : work.ages_s) {
    if (age_s <= mean_s) continue;
    sum_s += age_s;
    ++count;
  }
  return sum_s / count;
}

double time_left_s(const RunWorkload& work) {
  const double each_s = seconds_per_demonstration(work);
  double sum_s = each_s * static_cast<double>(work.waiting), longest_s = 0;
  for (const double age_s : work.ages_s) {
    const double left_s = std::max(0.0, each_s - age_s);
    sum_s += left_s;
    longest_s = std::max(longest_s, left_s);
  }
  return std::max(sum_s / work.jobs, longest_s);
}

std::string duration_text(double seconds) {
  if (seconds < 90) return fmt::format("{:.0f} s", seconds);
  if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

}  // namespace morphe::run
