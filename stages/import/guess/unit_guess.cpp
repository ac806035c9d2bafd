#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/math/statistics.hpp"
#include "stages/import/guess/convention_guess.hpp"

namespace morphe::imports {
namespace {

/// A length of the body in recorded units and its usual value [m].
struct BodyLength {
  const char* what;
  double recorded, usual_m;
};

/// Returns lengths between joint centres, with usual values of adults; if clusters replace joints,
/// they are a third shorter or longer.
std::vector<BodyLength> body_lengths(const RecordedPoints& points) {
  std::vector<BodyLength> lengths;
  const auto add = [&](const char* what, const std::string& from, const std::string& to,
                       double usual_m) {
    const double length = math::median_distance(mean_track(points, from), mean_track(points, to));
    if (length > 0) lengths.push_back({what, length, usual_m});
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
    const double log = std::log(length.recorded * metres / length.usual_m);
    sum += log * log;
  }
  return std::sqrt(sum / static_cast<double>(lengths.size()));
}

std::string length_text(double metres) {
  return metres < 0.995 ? fmt::format("{:.0f} mm", 1000 * metres) : fmt::format("{:.2f} m", metres);
}

/// Guesses the unit from the extent, if no body part is known: a person reaches over half a metre
/// or a few.
Guess guess_unit_from_extent(const RecordedPoints& points) {
  Eigen::AlignedBox3d box;
  for (const Vec3& point : points.position.values) {
    if (is_known(point)) box.extend(point);
  }
  if (box.isEmpty() || !(box.diagonal().norm() > 0)) return {};
  const std::vector<BodyLength> extent = {{"extent", box.diagonal().norm(), 1.0}};
  const auto best = std::ranges::min_element(
      kUnits, kUnits + 3, {}, [&](const auto& unit) { return misfit(extent, unit.second); });
  return {best->first, Confidence::guessed,
          fmt::format("all points lie within {}", length_text(extent[0].recorded * best->second))};
}

}  // namespace

Guess guess_unit(const RecordedPoints& points) {
  const std::vector<BodyLength> lengths = body_lengths(points);
  if (lengths.empty()) return guess_unit_from_extent(points);
  const auto best = std::ranges::min_element(
      kUnits, {}, [&](const auto& unit) { return misfit(lengths, unit.second); });
  constexpr double kUsualMisfit = 0.22, kPossibleMisfit = 0.45;  // logarithms: 25 and 57 %
  const double off = misfit(lengths, best->second);
  const BodyLength& first = lengths.front();
  if (off < kPossibleMisfit) {
    return {best->first, off < kUsualMisfit ? Confidence::sure : Confidence::likely,
            fmt::format("{} {} long", first.what, length_text(first.recorded * best->second))};
  }
  double logs = 0;
  for (const BodyLength& length : lengths) logs += std::log(length.usual_m / length.recorded);
  const double metres = std::exp(logs / static_cast<double>(lengths.size()));
  return {fmt::format("{:.3g}", metres), Confidence::guessed,
          fmt::format("gives the body usual lengths ({} {}); mm, cm, m, in and ft do not",
                      first.what, length_text(first.recorded * metres))};
}

Guess guess_rate(const RecordedPoints& points, double unit_m) {
  std::vector<double> speeds;  // per frame
  for (std::size_t i = 1; i < points.position.rows; ++i) {
    double fastest = 0;
    for (std::size_t k = 0; k < points.position.cols; ++k) {
      const double step = (points.position(i, k) - points.position(i - 1, k)).norm();
      if (step > fastest) fastest = step;
    }
    speeds.push_back(fastest * unit_m);
  }
  if (speeds.empty()) return {};
  const auto at = speeds.begin() + (speeds.size() * 95 / 100);
  std::ranges::nth_element(speeds, at);
  constexpr double kUsualRates_hz[] = {30, 60, 100, 120, 200, 240}, kReachSpeed_m_s = 1;
  const double rate = *std::ranges::min_element(kUsualRates_hz, {}, [&](double hz) {
    return *at > 0 ? std::abs(std::log(*at * hz / kReachSpeed_m_s)) : hz;
  });
  return {fmt::format("{:.0f}", rate), Confidence::guessed,
          fmt::format("the hand then moves at up to {:.1f} m/s; enter the frame rate of the camera",
                      *at * rate)};
}

}  // namespace morphe::imports
