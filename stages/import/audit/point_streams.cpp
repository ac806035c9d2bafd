#include "stages/import/audit/point_streams.hpp"

#include "core/math/statistics.hpp"
#include "stages/import/guess/recorded_points.hpp"
#include "stages/import/recording/arm_names.hpp"

namespace morphe::imports {
namespace {

void hide_in(const HiddenRows& hidden, Array2D<Vec3>& position, Array2D<Quat>* orientation) {
  for (std::size_t i = hidden.begin; i < hidden.end; ++i) {
    position(i, hidden.point) = unknown_point();
    if (orientation && orientation->rows > 0) (*orientation)(i, hidden.point) = unknown_rotation();
  }
}

}  // namespace

std::vector<PointStream> point_streams(const Demonstration& recording) {
  const Streams& streams = recording.streams;
  std::vector<PointStream> found;
  const std::string_view other = name_of(recording.hand == Side::right ? Side::left : Side::right);
  const auto add = [&](PointStreamKind kind, const std::vector<std::string>& names,
                       const auto& stream) {
    if (stream.position.rows == 0) return;
    std::vector<bool> other_side;
    for (const std::string& name : names) other_side.push_back(body_part(name).starts_with(other));
    found.push_back({kind, names, std::move(other_side), stream.time, stream.position});
  };
  if (streams.markers) add(PointStreamKind::markers, streams.markers->names, *streams.markers);
  if (streams.sensors) add(PointStreamKind::sensors, streams.sensors->names, *streams.sensors);
  if (streams.skeleton) add(PointStreamKind::skeleton, streams.skeleton->names, *streams.skeleton);
  if (streams.hand) {
    const std::string side(name_of(recording.hand));
    add(PointStreamKind::hand, hand_point_names(streams.hand->kind, side), *streams.hand);
  }
  return found;
}

double median_period(const std::vector<double>& time) {
  std::vector<double> periods;
  for (std::size_t i = 1; i < time.size(); ++i) periods.push_back(time[i] - time[i - 1]);
  return math::median(std::move(periods));
}

void hide(const std::vector<HiddenRows>& hidden, Streams& streams) {
  for (const HiddenRows& rows : hidden) {
    switch (rows.kind) {
      case PointStreamKind::markers:
        hide_in(rows, streams.markers->position, nullptr);
        break;
      case PointStreamKind::sensors:
        hide_in(rows, streams.sensors->position, &streams.sensors->orientation);
        break;
      case PointStreamKind::skeleton:
        hide_in(rows, streams.skeleton->position, &streams.skeleton->orientation);
        break;
      case PointStreamKind::hand:
        hide_in(rows, streams.hand->position, nullptr);
        break;
    }
  }
}

}  // namespace morphe::imports
