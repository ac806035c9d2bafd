#include "stages/import/guess/facing.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "stages/import/guess/body_guess.hpp"
#include "stages/import/guess/turn_demonstration.hpp"

namespace morphe::imports {
namespace {

constexpr double kAgree = 0.6;   // cosine-like: cues further apart than that contradict
constexpr double kSteady = 0.8;  // of the shoulder line's mean over a recording, of its length
constexpr double kBegin_s = 1;   // of a recording in which the person turns
constexpr double kOtherWay = 45 * kDegree;

/// What cues of one kind say together.
std::optional<Facing> facing_by(const std::vector<BodyCue>& cues, CueOf kind) {
  double cosine = 0, sine = 0, weights = 0;
  std::vector<std::string> because;
  for (const BodyCue& cue : cues) {
    if (cue.of != kind || cue.signless || cue.use == CueFor::axes) continue;
    const double weight = cue.weight * cue.recorded.head<2>().norm() * cue.world.head<2>().norm();
    cosine += cue.weight * cue.world.head<2>().dot(cue.recorded.head<2>());
    sine += cue.weight * (cue.recorded.x() * cue.world.y() - cue.recorded.y() * cue.world.x());
    weights += weight;
    constexpr double kTells = 0.2;
    if (weight > kTells * cue.weight && std::ranges::find(because, cue.what) == because.end()) {
      because.emplace_back(cue.what);
    }
  }
  if (because.empty()) return std::nullopt;
  return Facing{std::atan2(sine, cosine), kind, std::hypot(sine, cosine) / weights, false,
                fmt::format("{}", fmt::join(because, "; "))};
}

/// Whether the trunk points the same way throughout.
bool is_steady(const RecordedPoints& points) {
  const auto left = mean_track(points, "left shoulder"),
             right = mean_track(points, "right shoulder");
  std::vector<Vec3> lines;
  double lengths = 0, count = 0;
  for (std::size_t i = 0; i < left.size(); ++i) {
    Vec3 line = right[i] - left[i];
    line.z() = 0;
    lines.push_back(line);
    if (!seen(line)) continue;
    lengths += line.norm();
    ++count;
  }
  return count == 0 || mean_of(lines).norm() > kSteady * lengths / count;
}

RecordedPoints begin_of(const RecordedPoints& points) {
  RecordedPoints begin = points;
  const auto until = std::ranges::upper_bound(points.time, points.time.front() + kBegin_s);
  const auto rows = static_cast<std::size_t>(until - points.time.begin());
  begin.time.resize(rows);
  begin.position.rows = rows;
  begin.position.values.resize(rows * points.position.cols);
  return begin;
}

std::string said_of(const Facing& facing) {
  const double degrees = facing.turn / kDegree;
  const std::string by =
      facing.by == CueOf::trunk
          ? facing.because
          : fmt::format("a guess by the {} alone: {}", facing.by == CueOf::arm ? "arm" : "hand",
                        facing.because);
  std::string text =
      std::abs(facing.turn) > kOtherWay
          ? fmt::format(
                "the person faces {:.0f} degrees away from where the recorded axes say: all "
                "was turned about the vertical, so that forward is where the body says ({})",
                std::abs(degrees), by)
          : fmt::format(
                "turned by {:.1f} degrees about the vertical, so that the person faces Y ({})",
                degrees, by);
  if (facing.turns) text += "; the person turns round later: by the first second";
  return text;
}

}  // namespace

std::optional<Facing> facing_of(const RecordedPoints& points, Side hand) {
  if (points.time.empty()) return std::nullopt;
  const RecordedPoints rest = points_at_rest(points, hand);
  const bool turns = !is_steady(rest);
  const std::vector<BodyCue> at_rest = body_cues(turns ? begin_of(rest) : rest),
                             throughout = body_cues(points);
  for (const CueOf kind : {CueOf::trunk, CueOf::arm, CueOf::hand, CueOf::way}) {
    std::optional<Facing> facing = facing_by(at_rest, kind);
    if (!facing) facing = facing_by(throughout, kind);
    if (!facing) continue;
    facing->turns = turns;
    return facing;
  }
  return std::nullopt;
}

namespace {

void turn_to_forward(const Conventions& given, Demonstration& demonstration) {
  const auto facing =
      facing_of(recorded_points(demonstration.streams, demonstration.hand), demonstration.hand);
  if (!facing) return;
  // An arm reaches to the side, too: it says less than a person who gives the axes.
  if (facing->by != CueOf::trunk && !given.axes.empty()) return;
  if (facing->agreement < kAgree) {
    demonstration.reports.push_back(
        fmt::format("which way the person faces is not clear, for these contradict each other: {}; "
                    "the recorded axes are kept",
                    facing->because));
    return;
  }
  turn_about_vertical(demonstration, facing->turn);
  demonstration.reports.push_back(said_of(*facing));
}

/// Says so where the body stands otherwise than the axes have it; of axes that were given, where it
/// does not stand upright in them.
void doubt_axes(bool given, Demonstration& demonstration) {
  const Guess guess = guess_axes(recorded_points(demonstration.streams, demonstration.hand));
  const bool upright = guess.value.ends_with(" z");
  if (guess.sure != Sureness::sure || guess.value == "x y z" || (given && upright)) return;
  demonstration.reports.push_back(
      fmt::format("the body stands otherwise than these axes have it: its right, forward and up "
                  "are their '{}' ({}); give --axes",
                  guess.value, guess.because));
}

}  // namespace

void face_forward(const Conventions& given, Demonstration& demonstration) {
  const Streams& streams = demonstration.streams;
  if (streams.skeleton && streams.skeleton->rebuilt) return;
  if (!streams.markers && !streams.sensors && !streams.skeleton) return;
  if (given.forward == ForwardBy::body) turn_to_forward(given, demonstration);
  doubt_axes(!given.axes.empty(), demonstration);
}

}  // namespace morphe::imports
