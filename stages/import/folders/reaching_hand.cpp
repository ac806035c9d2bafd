#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <set>

#include "stages/import/folders/entry_notes.hpp"
#include "stages/import/folders/recording_descriptor.hpp"
#include "stages/import/recording/name_words.hpp"
#include "stages/import/trackers/hand_curl.hpp"

namespace morphe::imports {
namespace {

constexpr double kMinMotionRatio = 1.25;      ///< least ratio of the motion of both sides
constexpr double kMinReach_m = 0.010;         ///< least motion of a reach
constexpr std::size_t kTestedPointCount = 3;  ///< points of a hand that are compared

std::optional<Side> side_of_letter(char letter) {
  if (letter == 'R' || letter == 'r') return Side::right;
  if (letter == 'L' || letter == 'l') return Side::left;
  return std::nullopt;
}

char other_letter(char letter) {
  constexpr std::string_view kFrom = "RrLl", kTo = "LlRr";
  return kTo[kFrom.find(letter)];
}

/// Returns the side of an R or L at an end of a name if the whole name is in capitals, or if the
/// name of the other side exists.
std::optional<Side> side_at_end(const std::string& name, std::size_t at,
                                const std::set<std::string_view>& all) {
  const std::optional<Side> side = side_of_letter(name[at]);
  if (!side) return side;
  std::string other = name;
  other[at] = other_letter(name[at]);
  const bool capitals = at == 0 && name.size() > 2 && std::ranges::none_of(name, [](char c) {
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
  const std::optional<Side> first = side_at_end(name, name.size() - own.size(), all);
  return first ? first : side_at_end(name, name.size() - 1, all);
}

/// Returns the mean of the largest deviations of a side's points [m], so that a single point has
/// less influence.
double mean_largest_deviation(std::vector<double> wander) {
  const std::size_t count = std::min(kTestedPointCount, wander.size());
  std::ranges::partial_sort(wander, wander.begin() + count, std::greater<>());
  double sum = 0;
  for (std::size_t k = 0; k < count; ++k) sum += wander[k];
  return sum / static_cast<double>(kTestedPointCount);
}

}  // namespace

ReachingHand reaching_hand(const Demonstration& demonstration, const RecordingDescriptor& sketch) {
  const auto& hand = demonstration.streams.hand;
  if (hand && hand->kind == HandKind::keypoints) {
    const double out = finger_curl_m(hand->position);
    if (std::abs(out) > kMinCurl_m) {
      const Side side = out < 0 ? Side::right : Side::left;
      return {side, fmt::format("the {} hand, judged by the curl of its fingers", name_of(side))};
    }
  }
  const std::set<std::string_view> all(sketch.points.begin(), sketch.points.end());
  std::vector<double> wander[2];
  for (std::size_t k = 0; k < sketch.points.size(); ++k) {
    const std::optional<Side> side = side_in_point_name(sketch.points[k], all);
    if (side) wander[static_cast<std::size_t>(*side)].push_back(sketch.rms_deviation_m[k]);
  }
  if (wander[0].empty() && wander[1].empty()) {
    return {Side::right,
            fmt::format("{}: the file does not show which hand reaches", kRightHandAssumed)};
  }
  for (const Side side : {Side::right, Side::left}) {
    if (!wander[1 - static_cast<std::size_t>(side)].empty()) continue;
    return {side, fmt::format("the {0} hand reaches: the file has only points of the {0} side",
                              name_of(side))};
  }
  const double right = mean_largest_deviation(wander[0]), left = mean_largest_deviation(wander[1]);
  if (std::max(right, left) <= std::max(kMinReach_m, kMinMotionRatio * std::min(right, left))) {
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

bool has_points_of_side(const RecordingDescriptor& sketch, Side side) {
  const std::set<std::string_view> all(sketch.points.begin(), sketch.points.end());
  return std::ranges::any_of(sketch.points, [&](const std::string& name) {
    return side_in_point_name(name, all) == side;
  });
}

}  // namespace morphe::imports
