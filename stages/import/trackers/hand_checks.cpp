#include "stages/import/trackers/hand_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/math/statistics.hpp"
#include "stages/import/recording/conventions.hpp"
#include "stages/import/trackers/add_note.hpp"
#include "stages/import/trackers/hand_curl.hpp"
#include "stages/import/trackers/time_unit.hpp"

namespace morphe::imports {
namespace {

/// From the wrist to the middle knuckle: a small child's, and more than the largest adult's.
constexpr double kMinPalmLength_m = 0.045, kMaxPalmLength_m = 0.14;
constexpr double kMaxBoneVariationRatio = 0.05;  ///< of bone_length_variation()
constexpr double kMaxFramePeriod_s = 0.045;      ///< for ten frames in a reach of half a second

std::vector<double> bone_lengths(const Array2D<Vec3>& joint, int from, int to) {
  std::vector<double> lengths;
  for (std::size_t i = 0; i < joint.rows; ++i) {
    const double length = (joint(i, to) - joint(i, from)).norm();
    if (std::isfinite(length)) lengths.push_back(length);
  }
  return lengths;
}

void check_size(const std::string& file, std::string_view side, const Array2D<Vec3>& joint) {
  const std::vector<double> palm = bone_lengths(joint, 0, 9);
  if (palm.empty()) return;
  const double length_m = math::median(palm);
  if (length_m >= kMinPalmLength_m && length_m <= kMaxPalmLength_m) return;
  throw UnresolvedConvention("unit",
                             fmt::format("{}: unit: implausible: the {} hand would measure {:.3g} "
                                         "m from the wrist to the middle finger's knuckle",
                                         file, side, length_m));
}

void check_side(const std::string& file, Side side, const Array2D<Vec3>& joint) {
  constexpr double kWrongSideCurl_m = 1.5 * kMinCurl_m;
  const double curl_m = finger_curl_m(joint);
  if (!((side == Side::right ? curl_m : -curl_m) > kWrongSideCurl_m)) return;
  const Side other = side == Side::right ? Side::left : Side::right;
  throw InputError(
      fmt::format("{}: {} hand: its fingers curl like those of a {} hand (by {:.0f} mm on "
                  "average): the sides are exchanged in the file, or its axes are left-handed",
                  file, name_of(side), name_of(other), 1000 * std::abs(curl_m)));
}

/// Returns the RMS over the bones of the standard deviation of their length over its mean.
double bone_length_variation(const Array2D<Vec3>& joint) {
  double square_sum = 0, bone_count = 0;
  for (int k = 1; k + 1 < kKeypointCount; ++k) {
    if (k % 4 == 0) continue;  // no bone begins at a tip
    const std::vector<double> lengths = bone_lengths(joint, k, k + 1);
    if (lengths.size() < 2) continue;
    double sum = 0, sum_squares = 0;
    for (const double length : lengths) sum += length, sum_squares += length * length;
    const auto count = static_cast<double>(lengths.size());
    const double mean = sum / count;
    square_sum += std::max(0.0, sum_squares / count / (mean * mean) - 1);
    ++bone_count;
  }
  return bone_count > 0 ? std::sqrt(square_sum / bone_count) : 0;
}

/// Returns a hand's keypoints, or the body's joints of these names; no value without any finger.
std::optional<Array2D<Vec3>> merged_hand_joints(const HandClip& clip, Side side) {
  const auto& hand = clip.hands[side_index(side)];
  Array2D<Vec3> joint =
      hand ? hand->keypoints : Array2D<Vec3>(clip.time.size(), kKeypointCount, unknown_point());
  bool fingers = false;
  const std::vector<std::string> names = keypoint_names(side);
  for (int k = 0; k < kKeypointCount; ++k) {
    const int column = name_index(clip.body.names, names[k]);
    if (column < 0) continue;
    fingers = fingers || k > 0;
    for (std::size_t i = 0; i < joint.rows; ++i) joint(i, k) = clip.body.position(i, column);
  }
  return hand || fingers ? std::optional(std::move(joint)) : std::nullopt;
}

void report_unseen(std::string_view side, const Array2D<Vec3>& joint,
                   std::vector<std::string>& reports) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < joint.rows; ++i) {
    bool any_seen = false;
    for (std::size_t k = 0; k < joint.cols; ++k) any_seen = any_seen || is_known(joint(i, k));
    if (any_seen) ++count;
  }
  if (count == joint.rows) return;
  add_note(reports, "the {} hand is visible in {} of {} frames", side, count, joint.rows);
}

void report_rate(const std::vector<double>& time, std::vector<std::string>& reports) {
  const double step_s = median_step(time);
  if (step_s > kMaxFramePeriod_s)
    add_note(reports, "only {:.3g} rows per second: too few to follow a reach", 1 / step_s);
}

}  // namespace

void check_hands(const std::string& file, const HandClip& clip, bool is_checked,
                 std::vector<std::string>& reports) {
  for (const Side side : {Side::right, Side::left}) {
    const std::optional<Array2D<Vec3>> joint = merged_hand_joints(clip, side);
    if (!joint) continue;
    const std::string_view name = name_of(side);
    report_unseen(name, *joint, reports);
    if (is_checked && clip.hands[side_index(side)]) check_size(file, name, *joint);
    if (is_checked) check_side(file, side, *joint);
    const double variation = bone_length_variation(*joint);
    if (variation > kMaxBoneVariationRatio) {
      add_note(reports,
               "the bone lengths of the {} hand vary by {:.0f} % (RMS): the tracker does not keep "
               "them constant, or joints are named wrongly",
               name, 100 * variation);
    }
  }
  report_rate(clip.time, reports);
}

}  // namespace morphe::imports
