#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/math/statistics.hpp"
#include "stages/import/guess/constants.hpp"
#include "stages/import/guess/convention_guess.hpp"

namespace morphe::imports {
namespace {

/// A length of the body in recorded units and its usual value [m].
struct BodyLength {
  const char* name;
  double recorded, usual_m;
};

/// Returns the lengths that were recorded, with the usual values of adults between joint centres.
/// Clusters of markers in place of joint centres make a length up to a third shorter or longer.
std::vector<BodyLength> body_lengths(const RecordedPoints& points) {
  std::vector<BodyLength> lengths;
  const auto add = [&](const char* name, const std::string& from, const std::string& to,
                       double usual_m) {
    const double length = math::median_distance(mean_track(points, from), mean_track(points, to));
    if (length > 0) lengths.push_back({name, length, usual_m});
  };
  add("shoulders", "left shoulder", "right shoulder", 0.36);
  for (const std::string side : {"right ", "left "}) {
    add("upper arm", side + "shoulder", side + "elbow", 0.29);
    add("forearm", side + "elbow", side + "wrist", 0.26);
    add("hand", side + "wrist", side + "middle tip", 0.18);
    add("hand", side + "wrist", side + "index tip", 0.17);
    add("upper arm to forearm", side + "upper arm", side + "forearm", 0.25);
    add("forearm to hand", side + "forearm", side + "hand", 0.2);
    add("hand to index tip", side + "hand", side + "index tip", 0.12);
  }
  return lengths;
}

constexpr std::pair<const char*, double> kUnits[] = {
    {"mm", 0.001}, {"cm", 0.01}, {"m", 1}, {"in", 0.0254}, {"ft", 0.3048}};

double misfit(const std::vector<BodyLength>& lengths, double metres) {
  double sum = 0;
  for (const BodyLength& length : lengths) {
    const double log_ratio = std::log(length.recorded * metres / length.usual_m);
    sum += log_ratio * log_ratio;
  }
  return std::sqrt(sum / static_cast<double>(lengths.size()));
}

std::string length_text(double metres) {
  return metres < 0.995 ? fmt::format("{:.0f} mm", 1000 * metres) : fmt::format("{:.2f} m", metres);
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
  double log_sum = 0;
  for (const BodyLength& length : lengths) log_sum += std::log(length.usual_m / length.recorded);
  const double metres = std::exp(log_sum / static_cast<double>(lengths.size()));
  return {fmt::format("{:.3g}", metres), Confidence::guessed,
          fmt::format("gives the body usual lengths ({} {}); mm, cm, m, in and ft do not",
                      first.name, length_text(first.recorded * metres))};
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
