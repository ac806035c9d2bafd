#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>

#include "stages/import/folders/manifest.hpp"
#include "stages/import/folders/recording_descriptor.hpp"
#include "stages/import/recording/name_words.hpp"
#include "stages/import/trackers/hand_curl.hpp"

namespace morphe::imports {
namespace {

constexpr double kMinRmsRatio = 1.25;            ///< of the reaching side's deviation to the other
constexpr double kMinRms_m = 0.010;              ///< rms deviation of the reaching side
constexpr std::ptrdiff_t kTestedPointCount = 3;  ///< points of a side that are compared

std::optional<Side> side_of_letter(char letter) {
  if (letter == 'R' || letter == 'r') return Side::right;
  if (letter == 'L' || letter == 'l') return Side::left;
  return std::nullopt;
}

/// Returns the side of the letter R or L at this index of a name, if one of `all` names has the
/// other letter there, or if it begins a name in capitals of at least three letters.
std::optional<Side> side_of_letter_at(const std::string& name, std::size_t index,
                                      const std::set<std::string_view>& all) {
  constexpr std::string_view kLetters = "RrLl", kOtherLetters = "LlRr";
  const std::optional<Side> side = side_of_letter(name[index]);
  if (!side) return side;
  std::string other = name;
  other[index] = kOtherLetters[kLetters.find(name[index])];
  const bool capitals = index == 0 && name.size() > 2 && std::ranges::none_of(name, [](char c) {
                          return std::islower(static_cast<unsigned char>(c)) != 0;
                        });
  return capitals || all.contains(other) ? side : std::nullopt;
}

std::optional<Side> side_in_point_name(const std::string& name,
                                       const std::set<std::string_view>& all) {
  const std::string_view own = std::string_view(name).substr(name.rfind(':') + 1);
  for (const NameWord& word : split_name(own)) {
    const std::optional<Side> side =
        word.text.size() == 1 ? side_of_letter(word.text[0]) : enum_from_name<Side>(word.text);
    if (side) return side;
  }
  if (own.empty()) return std::nullopt;
  const std::optional<Side> first = side_of_letter_at(name, name.size() - own.size(), all);
  return first ? first : side_of_letter_at(name, name.size() - 1, all);
}

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
      return {side, fmt::format("the {} hand, judged by the curl of its fingers", name_of(side))};
    }
  }
  const std::set<std::string_view> all(descriptor.points.begin(), descriptor.points.end());
  std::vector<double> right_m, left_m;
  for (int k = 0; k < std::ssize(descriptor.points); ++k) {
    const std::optional<Side> side = side_in_point_name(descriptor.points[k], all);
    if (side) (side == Side::right ? right_m : left_m).push_back(descriptor.rms_deviation_m[k]);
  }
  if (right_m.empty() && left_m.empty()) {
    return {Side::right,
            fmt::format("{}: the file does not show which hand reaches", kRightHandAssumed)};
  }
  if (right_m.empty() || left_m.empty()) {
    const Side side = left_m.empty() ? Side::right : Side::left;
    return {side, fmt::format("the {0} hand reaches: the file has only points of the {0} side",
                              name_of(side))};
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
  const std::set<std::string_view> all(descriptor.points.begin(), descriptor.points.end());
  return std::ranges::any_of(descriptor.points, [&](const std::string& name) {
    return side_in_point_name(name, all) == side;
  });
}

}  // namespace morphe::imports
