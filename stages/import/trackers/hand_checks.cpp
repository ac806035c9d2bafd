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

/// Wrist to the knuckle of the middle finger [m]: from a small child's to more than the largest.
constexpr double kShortest = 0.045, kLongest = 0.14;
constexpr double kSteadyBone = 0.05;  ///< share by which a tracked bone's length may vary
constexpr double kSlow_s = 0.045;     ///< a reach of half a second would have ten rows

std::vector<double> lengths(const Table<Vec3>& joint, std::size_t from, std::size_t to) {
  std::vector<double> all;
  for (std::size_t i = 0; i < joint.rows; ++i) {
    const double length = (joint(i, to) - joint(i, from)).norm();
    if (std::isfinite(length)) all.push_back(length);
  }
  return all;
}

void check_size(const std::string& file, std::string_view side, const Table<Vec3>& joint) {
  std::vector<double> palm = lengths(joint, 0, 9);
  if (palm.empty()) return;
  const double usual = math::median(palm);
  if (usual >= kShortest && usual <= kLongest) return;
  throw NotSaid("unit",
                fmt::format("{}: unit: cannot be right: the {} hand would measure {:.3g} m from "
                            "the wrist to the middle finger's knuckle",
                            file, side, usual));
}

void check_side(const std::string& file, Side side, const Table<Vec3>& joint) {
  constexpr double kSure_m = 1.5 * kCurl_m;
  const double out = curl_away_from_right_palm(joint);
  if (!((side == Side::right ? out : -out) > kSure_m)) return;
  const Side other = side == Side::right ? Side::left : Side::right;
  throw InputError(fmt::format(
      "{}: {} hand: its fingers curl as those of a {} hand do (by {:.0f} mm in the mean): the "
      "sides are exchanged in the file, or its axes are left-handed",
      file, name_of(side), name_of(other), 1000 * std::abs(out)));
}

/// Root mean square over the bones of the fingers of how much each varies around its mean [1].
double unsteadiness(const Table<Vec3>& joint) {
  double squares = 0, bones = 0;
  for (std::size_t k = 1; k + 1 < kKeypoints; ++k) {
    if (k % 4 == 0) continue;  // a tip begins no bone
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

/// All that the clip has of a hand, among the joints of the body, too; nothing if that is no more
/// than its wrist.
std::optional<Table<Vec3>> hand_in(const HandClip& clip, Side side) {
  const auto& hand = clip.hands[static_cast<std::size_t>(side)];
  Table<Vec3> joint =
      hand ? hand->joint : Table<Vec3>(clip.time.size(), kKeypoints, unseen_point());
  bool fingers = false;
  const std::vector<std::string> names = keypoint_names(side);
  for (std::size_t k = 0; k < kKeypoints; ++k) {
    const auto found = std::ranges::find(clip.body.names, names[k]);
    if (found == clip.body.names.end()) continue;
    fingers = fingers || k > 0;
    const auto column = static_cast<std::size_t>(found - clip.body.names.begin());
    for (std::size_t i = 0; i < joint.rows; ++i) joint(i, k) = clip.body.position(i, column);
  }
  return hand || fingers ? std::optional(std::move(joint)) : std::nullopt;
}

void report_unseen(std::string_view side, const Table<Vec3>& joint,
                   std::vector<std::string>& reports) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < joint.rows; ++i) {
    bool any = false;
    for (std::size_t k = 0; k < joint.cols; ++k) any = any || seen(joint(i, k));
    if (any) ++count;
  }
  if (count < joint.rows) {
    reports.push_back(
        fmt::format("the {} hand was seen in {} of {} frames", side, count, joint.rows));
  }
}

void report_rate(const std::vector<double>& time, std::vector<std::string>& reports) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < time.size(); ++i) steps.push_back(time[i] - time[i - 1]);
  if (steps.empty()) return;
  const double step_s = math::median(steps);
  if (step_s > kSlow_s) {
    reports.push_back(
        fmt::format("only {:.3g} rows a second: too few to follow a reach", 1 / step_s));
  }
}

}  // namespace

void check_hands(const std::string& file, const HandClip& clip, bool judged,
                 std::vector<std::string>& reports) {
  for (const Side side : {Side::right, Side::left}) {
    const std::optional<Table<Vec3>> joint = hand_in(clip, side);
    if (!joint) continue;
    const std::string_view name = name_of(side);
    report_unseen(name, *joint, reports);
    if (judged && clip.hands[static_cast<std::size_t>(side)]) check_size(file, name, *joint);
    check_side(file, side, *joint);
    const double unsteady = unsteadiness(*joint);
    if (unsteady > kSteadyBone) {
      reports.push_back(fmt::format(
          "the bones of the {} hand vary in length by {:.0f} % (root mean square): the tracker "
          "does not keep them, or its joints are not those they are called",
          name, 100 * unsteady));
    }
  }
  report_rate(clip.time, reports);
}

}  // namespace morphe::imports
