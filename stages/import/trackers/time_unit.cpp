#include "stages/import/trackers/time_unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/statistics.hpp"
#include "core/motion/geometry.hpp"
#include "stages/import/recording/assumption_notes.hpp"
#include "stages/import/recording/conventions.hpp"
#include "stages/import/trackers/add_note.hpp"

namespace morphe::imports {
namespace {

// Chosen by hand: a reach of half a second has too few rows beyond 1 s, and no camera that follows
// a person is faster than 1 kHz. The two are a factor of 1000 apart, so that one unit fits at most.
constexpr double kMinRowPeriod_s = 1e-3, kMaxRowPeriod_s = 1;
constexpr std::pair<const char*, double> kSecondsPer[] = {
    {"s", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}};

bool are_frame_numbers(const std::vector<double>& time) {
  return median_step(time) == 1 &&
         std::ranges::all_of(time, [](double value) { return value == std::floor(value); });
}

}  // namespace

double median_step(const std::vector<double>& time) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < time.size(); ++i) steps.push_back(time[i] - time[i - 1]);
  return steps.empty() ? kUnknown : math::median(steps);
}

double seconds_per_unit(const std::string& column, const std::string& unit,
                        const std::vector<double>& time, const std::string& source,
                        std::vector<std::string>& reports) {
  const double step = median_step(time);
  if (unit.empty() && are_frame_numbers(time)) {
    throw UnresolvedConvention(
        "rate", fmt::format("{}: rate: '{}' has whole numbers with the step 1, as numbers of "
                            "frames have; give --rate or `rate_hz:` in frames per second",
                            source, column));
  }
  for (const auto& [name, seconds] : kSecondsPer) {
    if (unit == name) return seconds;
    const double period_s = step * seconds;
    if (!unit.empty() || !(period_s >= kMinRowPeriod_s && period_s < kMaxRowPeriod_s)) continue;
    add_note(reports, "unit of '{}' {} {}, {:.4g} rows per second", column, kTimeUnitAssumed, name,
             1 / period_s);
    return seconds;
  }
  return 1;
}

}  // namespace morphe::imports
