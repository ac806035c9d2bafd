#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "stages/import/folders/manifest.hpp"
#include "stages/import/folders/recording_descriptor.hpp"
#include "stages/import/recording/assumption_notes.hpp"
#include "stages/import/recording/name_sides.hpp"
#include "stages/import/trackers/hand_curl.hpp"

namespace morphe::imports {
namespace {

constexpr double kMinRmsRatio = 1.25;            ///< of the reaching side's deviation to the other
constexpr double kMinRms_m = 0.010;              ///< rms deviation of the reaching side
constexpr std::ptrdiff_t kTestedPointCount = 3;  ///< points of a side that are compared

/// Returns a third of the sum of the largest three deviations [m], or of all if there are fewer.
double mean_largest_deviation(std::vector<double> deviations_m) {
  const auto end = deviations_m.begin() + std::min(kTestedPointCount, std::ssize(deviations_m));
  std::ranges::partial_sort(deviations_m, end, std::greater<>());
  return std::accumulate(deviations_m.begin(), end, 0.0) / double{kTestedPointCount};
}

}  // namespace

ReachingHand reaching_hand(const Demonstration& demonstration,
                           const RecordingDescriptor& descriptor) {
  const auto& hand = demonstration.streams.hand;
  if (hand && hand->kind == HandKind::keypoints) {
    const double curl_m = finger_curl_m(hand->position);
    if (std::abs(curl_m) > kMinCurl_m) {
      const Side side = curl_m < 0 ? Side::right : Side::left;
      return {side, fmt::format("the {} hand, {}", name_of(side), kHandCurls)};
    }
  }
  const std::vector<NameSide> sides = sides_of_names(descriptor.points);
  std::vector<double> right_m, left_m;
  for (int k = 0; k < std::ssize(descriptor.points); ++k) {
    const std::optional<Side> side = sides[k].body;
    if (side) (side == Side::right ? right_m : left_m).push_back(descriptor.rms_deviation_m[k]);
  }
  if (right_m.empty() && left_m.empty()) {
    return {Side::right,
            fmt::format("{}: the file does not show which hand reaches", kRightHandAssumed)};
  }
  if (right_m.empty() || left_m.empty()) {
    const Side side = left_m.empty() ? Side::right : Side::left;
    return {side, fmt::format("the {0} {1}the file has only points of the {0} side", name_of(side),
                              kHandReaches)};
  }
  const double right = mean_largest_deviation(right_m), left = mean_largest_deviation(left_m);
  if (std::max(right, left) <= std::max(kMinRms_m, kMinRmsRatio * std::min(right, left))) {
    return {Side::right,
            fmt::format("{}: the right one moves by {:.0f} mm, the left one by {:.0f} mm",
                        kRightHandAssumed, 1000 * right, 1000 * left)};
  }
  const Side side = right > left ? Side::right : Side::left;
  const Side other = right > left ? Side::left : Side::right;
  return {
      side,
      fmt::format(
          "the {} hand reaches: its points move by {:.0f} mm, those of the {} hand by {:.0f} mm",
          name_of(side), 1000 * std::max(right, left), name_of(other),
          1000 * std::min(right, left))};
}

bool has_points_of_side(const RecordingDescriptor& descriptor, Side side) {
  return std::ranges::any_of(sides_of_names(descriptor.points),
                             [&](const NameSide& name) { return name.body == side; });
}

}  // namespace morphe::imports
