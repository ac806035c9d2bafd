#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/math/statistics.hpp"
#include "stages/import/guess/body_lengths.hpp"
#include "stages/import/guess/constants.hpp"
#include "stages/import/guess/convention_guess.hpp"

namespace morphe::imports {
namespace {

constexpr std::pair<const char*, double> kUnits[] = {
    {"mm", 0.001}, {"cm", 0.01}, {"m", 1}, {"in", 0.0254}, {"ft", 0.3048}};

/// Returns how far a length is from its usual value, with units of this length [m].
double log_ratio(const BodyLength& length, double metres) { return std::log(length.ratio(metres)); }

double misfit(const std::vector<BodyLength>& lengths, double metres) {
  double sum = 0;
  for (const BodyLength& length : lengths) {
    const double log_misfit = log_ratio(length, metres);
    sum += log_misfit * log_misfit;
  }
  return std::sqrt(sum / static_cast<double>(lengths.size()));
}

/// Returns the misfit of most lengths, which a point in the wrong place does not change.
double median_misfit(const std::vector<BodyLength>& lengths, double metres) {
  std::vector<double> misfits;
  for (const BodyLength& length : lengths) misfits.push_back(std::abs(log_ratio(length, metres)));
  return math::median(misfits);
}

Guess guess_unit_from_extent(const RecordedPoints& points) {
  Eigen::AlignedBox3d box;
  for (const Vec3& point : points.position.values) {
    if (is_known(point)) box.extend(point);
  }
  if (box.isEmpty() || !(box.diagonal().norm() > 0)) return {};
  const std::vector<BodyLength> extent = {{"extent", box.diagonal().norm(), kUsualExtent_m}};
  const auto [unit, metres] = *std::ranges::min_element(  // of mm, cm and m
      kUnits, kUnits + 3, {}, [&](const auto& known) { return misfit(extent, known.second); });
  return {unit, Confidence::guessed,
          fmt::format("all points lie within {}", length_text(extent[0].recorded * metres))};
}

}  // namespace

Guess guess_unit(const RecordedPoints& points) {
  const std::vector<BodyLength> lengths = body_lengths(points);
  if (lengths.empty()) return guess_unit_from_extent(points);
  const auto [unit, unit_m] = *std::ranges::min_element(
      kUnits, {}, [&](const auto& known) { return misfit(lengths, known.second); });
  const double unit_misfit = misfit(lengths, unit_m);
  const BodyLength& first = lengths.front();
  if (unit_misfit < kLikelyMisfit) {
    return {unit, unit_misfit < kSureMisfit ? Confidence::sure : Confidence::likely,
            fmt::format("{} {} long", first.name, length_text(first.recorded * unit_m))};
  }
  const auto [likeliest, metres] = *std::ranges::min_element(
      kUnits, {}, [&](const auto& known) { return median_misfit(lengths, known.second); });
  const BodyLength& worst =
      *std::ranges::max_element(lengths, {}, [&, metres = metres](const BodyLength& length) {
        return std::abs(log_ratio(length, metres));
      });
  return {
      likeliest, Confidence::guessed,
      fmt::format("the nearest unit, although {} would then measure {} instead of {}: the "
                  "names cannot be right",
                  worst.name, length_text(worst.recorded * metres), length_text(worst.usual_m))};
}

Guess guess_rate(const RecordedPoints& points, double unit_m) {
  std::vector<double> steps_m;  // of the fastest point, from frame to frame
  for (std::size_t i = 1; i < points.position.rows; ++i) {
    double largest_step = 0;
    for (std::size_t k = 0; k < points.position.cols; ++k) {
      const double step = (points.position(i, k) - points.position(i - 1, k)).norm();
      if (step > largest_step) largest_step = step;
    }
    steps_m.push_back(largest_step * unit_m);
  }
  if (steps_m.empty()) return {};
  const auto fast_step_m = steps_m.begin() + (steps_m.size() * kFastPercentile / 100);
  std::ranges::nth_element(steps_m, fast_step_m);
  const double rate_hz = *std::ranges::min_element(kUsualRates_hz, {}, [&](double hz) {
    return *fast_step_m > 0 ? std::abs(std::log(*fast_step_m * hz / kReachSpeed_m_s)) : hz;
  });
  return {fmt::format("{:.0f}", rate_hz), Confidence::guessed,
          fmt::format("the hand then moves at up to {:.1f} m/s; enter the frame rate of the camera",
                      *fast_step_m * rate_hz)};
}

}  // namespace morphe::imports
