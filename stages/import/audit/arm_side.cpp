#include "stages/import/audit/arm_side.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "core/math/statistics.hpp"

namespace morphe::imports {
namespace {

/// Returns the horizontal direction to the right of a horizontal or inclined one.
Vec3 right_of(const Vec3& forward) { return forward.cross(Vec3::UnitZ()).normalized(); }

double known_median(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  return math::median(std::move(values));
}

}  // namespace

ArmBearing arm_bearing(const RecordedPoints& points, Side side) {
  const std::string prefix = std::string(name_of(side)) + " ";
  const auto track = [&](const char* part) { return mean_track(points, prefix + part); };
  const auto shoulder = track("shoulder"), elbow = track("elbow"), wrist = track("wrist"),
             thumb = track("thumb tip"), index = track("index tip");
  const double outwards = side == Side::right ? 1 : -1;
  std::vector<double> angles, thumbs, elbows;
  for (std::size_t i = 0; i < points.time.size(); ++i) {
    angles.push_back(std::acos((shoulder[i] - elbow[i]).normalized().z()));
    const Vec3 hand = (thumb[i] + index[i]) / 2 - wrist[i];
    thumbs.push_back(-outwards * (thumb[i] - index[i]).dot(right_of(hand)));
    elbows.push_back(outwards * (elbow[i] - shoulder[i]).dot(right_of(wrist[i] - shoulder[i])));
  }
  return {known_median(angles), known_median(thumbs), known_median(elbows)};
}

}  // namespace morphe::imports
