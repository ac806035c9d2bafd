#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/math/statistics.hpp"
#include "stages/import/audit/checks.hpp"
#include "stages/import/audit/constants.hpp"
#include "stages/import/audit/label_timeline.hpp"
#include "stages/import/guess/recorded_points.hpp"
#include "stages/import/recording/arm_names.hpp"

namespace morphe::imports {
namespace {

/// Points that carry each other's names: that of track cycle[j] is in column cycle[j + 1].
struct WrongNames {
  std::vector<std::size_t> cycle;
  std::size_t begin = 0, end = 0;  ///< frames
};

/// Returns the wrong names of a timeline; those that go on over several of its parts once.
std::vector<WrongNames> wrong_names(const LabelTimeline& timeline) {
  std::vector<WrongNames> all;
  for (std::size_t p = 0; p < timeline.parts.size(); ++p) {
    const LabelPart& part = timeline.parts[p];
    for (auto& cycle : cycles_of(part.source)) {
      const auto before = std::ranges::find_if(
          all, [&](const auto& wrong) { return wrong.end == part.begin && wrong.cycle == cycle; });
      if (before != all.end())
        before->end = timeline.end_of(p);
      else
        all.push_back({std::move(cycle), part.begin, timeline.end_of(p)});
    }
  }
  return all;
}

/// Moves the values of the frames to the columns of their tracks.
template <class T>
void move_back(const WrongNames& wrong, Array2D<T>& values) {
  if (values.rows < wrong.end) return;
  for (std::size_t i = wrong.begin; i < wrong.end; ++i) {
    const T first = values(i, wrong.cycle.front());
    for (std::size_t j = 0; j + 1 < wrong.cycle.size(); ++j)
      values(i, wrong.cycle[j]) = values(i, wrong.cycle[j + 1]);
    values(i, wrong.cycle.back()) = first;
  }
}

bool names_digits(const std::vector<std::string>& names) {
  if (names.size() != 2) return false;
  std::vector<std::string> parts = {body_part(names[0]), body_part(names[1])};
  std::ranges::sort(parts);
  return parts[0].ends_with(" index tip") && parts[1].ends_with(" thumb tip");
}

std::string when(const WrongNames& wrong, const std::vector<double>& time) {
  const bool to_the_end = wrong.end == time.size();
  if (wrong.begin == 0 && to_the_end) return "in the whole recording";
  const std::string from = wrong.begin > 0 ? fmt::format("from {:.2f} s", time[wrong.begin]) : "";
  const std::string until = to_the_end ? "" : fmt::format("until {:.2f} s", time[wrong.end]);
  return from.empty() ? until : until.empty() ? from : from + " " + until;
}

std::string sentence(const std::vector<std::string>& names, const std::string& when) {
  if (names.size() == 2) return fmt::format("{} and {} exchanged {}", names[0], names[1], when);
  std::vector<std::string> carried(names.begin() + 1, names.end());
  carried.push_back(names.front());
  return fmt::format("{} named {} {}", fmt::join(names, ", "), fmt::join(carried, ", "), when);
}

/// Returns the median distance of the points from those that carry their names [m].
double median_displacement(const WrongNames& wrong, const Array2D<Vec3>& position) {
  std::vector<double> distances;
  for (std::size_t i = wrong.begin; i < wrong.end; ++i) {
    const double distance_m = (position(i, wrong.cycle[0]) - position(i, wrong.cycle[1])).norm();
    if (std::isfinite(distance_m)) distances.push_back(distance_m);
  }
  return math::median(std::move(distances));
}

Doubt doubt_of(const WrongNames& wrong, const std::vector<std::string>& all_names,
               const std::vector<double>& time, const Array2D<Vec3>& position) {
  std::vector<std::string> names;
  for (const std::size_t column : wrong.cycle) names.push_back(all_names[column]);
  if (names_digits(names)) std::ranges::sort(names, std::greater<>(), body_part);  // thumb first
  Doubt doubt;
  RecordingFlag& flag = doubt.flag;
  flag.code = names_digits(names) ? FlagCode::exchanged_digits : FlagCode::exchanged_markers;
  if (wrong.begin > 0 || wrong.end < time.size()) {
    flag.begin_s = time[wrong.begin];
    flag.end_s = time[wrong.end - 1];
  }
  flag.subject = fmt::format("{}", fmt::join(names, ", "));
  flag.value = median_displacement(wrong, position);
  flag.limit = kMinExchangeJump_m;
  flag.unit = "m";
  flag.text = sentence(names, when(wrong, time));
  return doubt;
}

/// Moves the values of one stream to the columns of their tracks.
using MoveBack = void (*)(const WrongNames&, Streams&);

void add_doubts(const std::vector<WrongNames>& all, const std::vector<std::string>& names,
                const std::vector<double>& time, const Array2D<Vec3>& position, MoveBack move,
                std::vector<Doubt>& doubts) {
  for (const WrongNames& wrong : all) {
    doubts.push_back(doubt_of(wrong, names, time, position));
    doubts.back().mend = [wrong, move](Demonstration& mended) { move(wrong, mended.streams); };
  }
}

void move_back(const WrongNames& wrong, BodyStream& bodies) {
  move_back(wrong, bodies.position);
  move_back(wrong, bodies.orientation);
  move_back(wrong, bodies.confidence);
}

/// Adds doubts about bodies that carry each other's names.
void check_bodies(const std::optional<BodyStream>& bodies, MoveBack move,
                  std::vector<Doubt>& doubts) {
  if (!bodies || bodies->reconstructed) return;
  add_doubts(wrong_names(find_joint_labels(bodies->time, bodies->position, bodies->names)),
             bodies->names, bodies->time, bodies->position, move, doubts);
}

}  // namespace

std::vector<Doubt> check_labels(const Demonstration& recording, const AuditInput& /*input*/) {
  std::vector<Doubt> doubts;
  const Streams& streams = recording.streams;
  if (streams.markers) {
    const MarkerStream& markers = *streams.markers;
    add_doubts(
        wrong_names(find_labels(markers, recording.calibration.markers)), markers.names,
        markers.time, markers.position,
        [](const WrongNames& wrong, Streams& moved) { move_back(wrong, moved.markers->position); },
        doubts);
  }
  check_bodies(
      streams.skeleton,
      [](const WrongNames& wrong, Streams& moved) { move_back(wrong, *moved.skeleton); }, doubts);
  check_bodies(
      streams.sensors,
      [](const WrongNames& wrong, Streams& moved) { move_back(wrong, *moved.sensors); }, doubts);
  if (streams.hand && streams.hand->position.rows > 0) {
    const HandStream& hand = *streams.hand;
    add_doubts(
        wrong_names(continued_tracks(hand.time, hand.position)),
        hand_point_names(hand.kind, std::string(name_of(recording.hand))), hand.time, hand.position,
        [](const WrongNames& wrong, Streams& moved) { move_back(wrong, moved.hand->position); },
        doubts);
  }
  return doubts;
}

}  // namespace morphe::imports
