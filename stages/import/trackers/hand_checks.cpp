#include "stages/import/trackers/hand_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/math/statistics.hpp"
#include "stages/import/recording/conventions.hpp"
#include "stages/import/trackers/hand_curl.hpp"

namespace morphe::imports {
namespace {

/// Limits on the distance from the wrist to the knuckle of the middle finger [m]: from a small
/// child's to more than the largest.
constexpr double kMinPalmLength_m = 0.045, kMaxPalmLength_m = 0.14;
/// Largest relative variation of a tracked bone's length.
constexpr double kMaxBoneVariationRatio = 0.05;
constexpr double kMaxFramePeriod_s = 0.045;  ///< ten rows in a reach of half a second need this

std::vector<double> lengths(const Array2D<Vec3>& joint, std::size_t from, std::size_t to) {
  std::vector<double> all;
  for (std::size_t i = 0; i < joint.rows; ++i) {
    const double length = (joint(i, to) - joint(i, from)).norm();
    if (std::isfinite(length)) all.push_back(length);
  }
  return all;
}

void check_size(const std::string& file, std::string_view side, const Array2D<Vec3>& joint) {
  std::vector<double> palm = lengths(joint, 0, 9);
  if (palm.empty()) return;
  const double usual = math::median(palm);
  if (usual >= kMinPalmLength_m && usual <= kMaxPalmLength_m) return;
  throw UnresolvedConvention("unit",
                             fmt::format("{}: unit: implausible: the {} hand would measure {:.3g} "
                                         "m from the wrist to the middle finger's knuckle",
                                         file, side, usual));
}

void check_side(const std::string& file, Side side, const Array2D<Vec3>& joint) {
  constexpr double kWrongSideCurl_m = 1.5 * kMinCurl_m;
  const double out = finger_curl_m(joint);
  if (!((side == Side::right ? out : -out) > kWrongSideCurl_m)) return;
  const Side other = side == Side::right ? Side::left : Side::right;
  throw InputError(
      fmt::format("{}: {} hand: its fingers curl like those of a {} hand (by {:.0f} mm on "
                  "average): the sides are exchanged in the file, or its axes are left-handed",
                  file, name_of(side), name_of(other), 1000 * std::abs(out)));
}

/// Returns the root mean square over the finger bones of their relative variation in length.
double bone_length_variation(const Array2D<Vec3>& joint) {
  double squares = 0, bones = 0;
  for (std::size_t k = 1; k + 1 < kKeypointCount; ++k) {
    if (k % 4 == 0) continue;  // no bone begins at a tip
    const std::vector<double> all = lengths(joint, k, k + 1);
    if (all.size() < 2) continue;
    double sum = 0, sum_squares = 0;
    for (const double length : all) sum += length, sum_squares += length * length;
    const double mean = sum / static_cast<double>(all.size());
    squares += std::max(0.0, sum_squares / static_cast<double>(all.size()) / (mean * mean) - 1);
    ++bones;
  }
  return bones > 0 ? std::sqrt(squares / bones) : 0;
}

/// Returns all joints of a hand in the clip, including those among the body's; no value if that is
/// at most its wrist.
std::optional<Array2D<Vec3>> merged_hand_joints(const HandClip& clip, Side side) {
  const auto& hand = clip.hands[static_cast<std::size_t>(side)];
  Array2D<Vec3> joint =
      hand ? hand->keypoints : Array2D<Vec3>(clip.time.size(), kKeypointCount, unknown_point());
  bool fingers = false;
  const std::vector<std::string> names = keypoint_names(side);
  for (std::size_t k = 0; k < kKeypointCount; ++k) {
    const auto found = std::ranges::find(clip.body.names, names[k]);
    if (found == clip.body.names.end()) continue;
    fingers = fingers || k > 0;
    const auto column = static_cast<std::size_t>(found - clip.body.names.begin());
    for (std::size_t i = 0; i < joint.rows; ++i) joint(i, k) = clip.body.position(i, column);
  }
  return hand || fingers ? std::optional(std::move(joint)) : std::nullopt;
}

void report_unseen(std::string_view side, const Array2D<Vec3>& joint,
                   std::vector<std::string>& reports) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < joint.rows; ++i) {
    bool any = false;
    for (std::size_t k = 0; k < joint.cols; ++k) any = any || is_known(joint(i, k));
    if (any) ++count;
  }
  if (count < joint.rows) {
    reports.push_back(
        fmt::format("the {} hand is visible in {} of {} frames", side, count, joint.rows));
  }
}

void report_rate(const std::vector<double>& time, std::vector<std::string>& reports) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < time.size(); ++i) steps.push_back(time[i] - time[i - 1]);
  if (steps.empty()) return;
  const double step_s = math::median(steps);
  if (step_s > kMaxFramePeriod_s) {
    reports.push_back(
        fmt::format("only {:.3g} rows per second: too few to follow a reach", 1 / step_s));
  }
}

}  // namespace

void check_hands(const std::string& file, const HandClip& clip, bool judged,
                 std::vector<std::string>& reports) {
  for (const Side side : {Side::right, Side::left}) {
    const std::optional<Array2D<Vec3>> joint = merged_hand_joints(clip, side);
    if (!joint) continue;
    const std::string_view name = name_of(side);
    report_unseen(name, *joint, reports);
    if (judged && clip.hands[static_cast<std::size_t>(side)]) check_size(file, name, *joint);
    check_side(file, side, *joint);
    const double unsteady = bone_length_variation(*joint);
    if (unsteady > kMaxBoneVariationRatio) {
      reports.push_back(
          fmt::format("the bone lengths of the {} hand vary by {:.0f} % (RMS): the tracker does "
                      "not keep them constant, or joints are named wrongly",
                      name, 100 * unsteady));
    }
  }
  report_rate(clip.time, reports);
}

}  // namespace morphe::imports
