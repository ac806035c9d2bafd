#include "stages/import/guess/heading.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "stages/import/guess/constants.hpp"
#include "stages/import/guess/convention_guess.hpp"
#include "stages/import/guess/rotate_demonstration.hpp"
#include "stages/import/recording/assumption_notes.hpp"

namespace morphe::imports {
namespace {

std::optional<HeadingEstimate> heading_from_cues(const std::vector<BodyCue>& cues,
                                                 CueSource source) {
  double cosine_sum = 0, sine_sum = 0, weight_sum = 0;
  std::vector<std::string> reasons;
  for (const BodyCue& cue : cues) {
    if (cue.source != source || cue.undirected || cue.purpose == CuePurpose::axes) continue;
    const double weight = cue.weight * cue.recorded.head<2>().norm() * cue.world.head<2>().norm();
    cosine_sum += cue.weight * cue.world.head<2>().dot(cue.recorded.head<2>());
    sine_sum += cue.weight * (cue.recorded.x() * cue.world.y() - cue.recorded.y() * cue.world.x());
    weight_sum += weight;
    if (weight > kMinHorizontalProduct * cue.weight &&
        std::ranges::find(reasons, cue.description) == reasons.end()) {
      reasons.emplace_back(cue.description);
    }
  }
  if (reasons.empty()) return std::nullopt;
  return HeadingEstimate{std::atan2(sine_sum, cosine_sum), source,
                         std::hypot(sine_sum, cosine_sum) / weight_sum, false,
                         fmt::format("{}", fmt::join(reasons, "; "))};
}

bool has_constant_heading(const RecordedPoints& points) {
  const auto left = mean_track(points, "left shoulder"),
             right = mean_track(points, "right shoulder");
  std::vector<Vec3> left_to_right;
  double length_sum = 0, count = 0;
  for (int i = 0; i < std::ssize(left); ++i) {
    Vec3 horizontal = right[i] - left[i];
    horizontal.z() = 0;
    left_to_right.push_back(horizontal);
    if (!is_known(horizontal)) continue;
    length_sum += horizontal.norm();
    ++count;
  }
  return count == 0 || mean_of(left_to_right).norm() > kConstantHeadingRatio * length_sum / count;
}

RecordedPoints initial_interval(const RecordedPoints& points) {
  RecordedPoints initial = points;
  auto& [names, parts, parents, time, position] = initial;
  time.erase(std::ranges::upper_bound(time, time.front() + kInitialInterval_s), time.end());
  position.rows = time.size();
  position.values.resize(position.rows * position.cols);
  return initial;
}

std::string heading_report(const HeadingEstimate& facing) {
  const double degrees = facing.yaw_rad / kRadPerDegree;
  const std::string reason =
      facing.source == CueSource::trunk
          ? facing.reason
          : fmt::format("a guess from the {} only: {}",
                        facing.source == CueSource::arm ? "arm" : "hand", facing.reason);
  std::string text =
      std::abs(facing.yaw_rad) > kLargeYaw_rad
          ? fmt::format(
                "the person faces {:.0f} degrees away from the forward axis: the recording was "
                "rotated about the vertical, {} ({})",
                std::abs(degrees), kFacesY, reason)
          : fmt::format("recording rotated by {:.1f} degrees about the vertical, {} ({})", degrees,
                        kFacesY, reason);
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
  for (const CueSource source :
       {CueSource::trunk, CueSource::arm, CueSource::hand, CueSource::reach}) {
    std::optional<HeadingEstimate> facing = heading_from_cues(at_rest, source);
    if (!facing) facing = heading_from_cues(throughout, source);
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
                    facing->reason));
    return;
  }
  rotate_about_vertical(demonstration, facing->yaw_rad);
  demonstration.import_notes.push_back(heading_report(*facing));
}

/// Reports that the body faces another way than the axes. (Whether it is upright is the audit's.)
void report_axes_mismatch(Demonstration& demonstration) {
  const Guess guess = guess_axes(recorded_points(demonstration.streams, demonstration.hand));
  const bool upright = guess.value.ends_with(" z");
  if (guess.confidence != Confidence::sure || guess.value == "x y z" || !upright) return;
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
  if (given.axes.empty()) report_axes_mismatch(demonstration);
}

}  // namespace morphe::imports
