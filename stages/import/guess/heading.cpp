#include "stages/import/guess/heading.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "stages/import/guess/convention_guess.hpp"
#include "stages/import/guess/rotate_demonstration.hpp"

namespace morphe::imports {
namespace {

// Similar to a cosine: cues with a lower agreement are contradictory.
constexpr double kMinCueAgreement = 0.6;
// Mean vector of the shoulder line relative to its mean length.
constexpr double kConstantHeadingRatio = 0.8;
constexpr double kInitialInterval_s = 1;  // used if the person turns during the recording
constexpr double kLargeYaw_rad = 45 * kRadPerDegree;

/// Returns the heading estimated from cues of one kind.
std::optional<HeadingEstimate> heading_from_cues(const std::vector<BodyCue>& cues, CueSource kind) {
  double cosine = 0, sine = 0, weights = 0;
  std::vector<std::string> because;
  for (const BodyCue& cue : cues) {
    if (cue.source != kind || cue.undirected || cue.purpose == CuePurpose::axes) continue;
    const double weight = cue.weight * cue.recorded.head<2>().norm() * cue.world.head<2>().norm();
    cosine += cue.weight * cue.world.head<2>().dot(cue.recorded.head<2>());
    sine += cue.weight * (cue.recorded.x() * cue.world.y() - cue.recorded.y() * cue.world.x());
    weights += weight;
    constexpr double kMinHorizontalShare = 0.2;
    if (weight > kMinHorizontalShare * cue.weight &&
        std::ranges::find(because, cue.description) == because.end()) {
      because.emplace_back(cue.description);
    }
  }
  if (because.empty()) return std::nullopt;
  return HeadingEstimate{std::atan2(sine, cosine), kind, std::hypot(sine, cosine) / weights, false,
                         fmt::format("{}", fmt::join(because, "; "))};
}

/// Returns true if the heading of the trunk is constant.
bool has_constant_heading(const RecordedPoints& points) {
  const auto left = mean_track(points, "left shoulder"),
             right = mean_track(points, "right shoulder");
  std::vector<Vec3> lines;
  double lengths = 0, count = 0;
  for (std::size_t i = 0; i < left.size(); ++i) {
    Vec3 line = right[i] - left[i];
    line.z() = 0;
    lines.push_back(line);
    if (!is_known(line)) continue;
    lengths += line.norm();
    ++count;
  }
  return count == 0 || mean_of(lines).norm() > kConstantHeadingRatio * lengths / count;
}

RecordedPoints initial_interval(const RecordedPoints& points) {
  RecordedPoints begin = points;
  const auto until =
      std::ranges::upper_bound(points.time, points.time.front() + kInitialInterval_s);
  const auto rows = static_cast<std::size_t>(until - points.time.begin());
  begin.time.resize(rows);
  begin.position.rows = rows;
  begin.position.values.resize(rows * points.position.cols);
  return begin;
}

std::string heading_report(const HeadingEstimate& facing) {
  const double degrees = facing.yaw_rad / kRadPerDegree;
  const std::string by =
      facing.source == CueSource::trunk
          ? facing.because
          : fmt::format("a guess from the {} only: {}",
                        facing.source == CueSource::arm ? "arm" : "hand", facing.because);
  std::string text =
      std::abs(facing.yaw_rad) > kLargeYaw_rad
          ? fmt::format(
                "the person faces {:.0f} degrees away from the forward axis: the recording was "
                "rotated about the vertical, so that the person faces Y ({})",
                std::abs(degrees), by)
          : fmt::format(
                "recording rotated by {:.1f} degrees about the vertical, so that the person faces "
                "Y ({})",
                degrees, by);
  if (facing.heading_changes)
    text += "; the person turns later: facing direction of the first second";
  return text;
}

}  // namespace

std::optional<HeadingEstimate> estimate_heading(const RecordedPoints& points, Side hand) {
  if (points.time.empty()) return std::nullopt;
  const RecordedPoints rest = frames_at_rest(points, hand);
  const bool turns = !has_constant_heading(rest);
  const std::vector<BodyCue> at_rest = body_cues(turns ? initial_interval(rest) : rest),
                             throughout = body_cues(points);
  for (const CueSource kind :
       {CueSource::trunk, CueSource::arm, CueSource::hand, CueSource::reach}) {
    std::optional<HeadingEstimate> facing = heading_from_cues(at_rest, kind);
    if (!facing) facing = heading_from_cues(throughout, kind);
    if (!facing) continue;
    facing->heading_changes = turns;
    return facing;
  }
  return std::nullopt;
}

namespace {

void apply_body_heading(const Conventions& given, Demonstration& demonstration) {
  const auto facing = estimate_heading(recorded_points(demonstration.streams, demonstration.hand),
                                       demonstration.hand);
  if (!facing) return;
  // An arm also reaches sideways and is less reliable than axes given by a person.
  if (facing->source != CueSource::trunk && !given.axes.empty()) return;
  if (facing->agreement < kMinCueAgreement) {
    demonstration.import_notes.push_back(
        fmt::format("the facing direction is unclear, since these contradict each other: {}; the "
                    "recorded axes are kept",
                    facing->because));
    return;
  }
  rotate_about_vertical(demonstration, facing->yaw_rad);
  demonstration.import_notes.push_back(heading_report(*facing));
}

/// Reports a disagreement between body and axes; for given axes only if the body is not upright.
void report_axes_mismatch(bool given, Demonstration& demonstration) {
  const Guess guess = guess_axes(recorded_points(demonstration.streams, demonstration.hand));
  const bool upright = guess.value.ends_with(" z");
  if (guess.confidence != Confidence::sure || guess.value == "x y z" || (given && upright)) return;
  demonstration.import_notes.push_back(
      fmt::format("the posture of the body contradicts the axes: its right, forward and up are "
                  "'{}' ({}); give --axes",
                  guess.value, guess.reason));
}

}  // namespace

void align_heading(const Conventions& given, Demonstration& demonstration) {
  const Streams& streams = demonstration.streams;
  if (streams.skeleton && streams.skeleton->reconstructed) return;
  if (!streams.markers && !streams.sensors && !streams.skeleton) return;
  if (given.forward == ForwardSource::body) apply_body_heading(given, demonstration);
  report_axes_mismatch(!given.axes.empty(), demonstration);
}

}  // namespace morphe::imports
