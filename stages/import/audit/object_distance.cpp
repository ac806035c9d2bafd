#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/motion/bounding_box.hpp"
#include "stages/import/audit/checks.hpp"
#include "stages/import/audit/constants.hpp"
#include "stages/import/guess/recorded_points.hpp"

namespace morphe::imports {
namespace {

Doubt of_object(const SceneObject& object, double value_m, double limit_m, std::string text) {
  return {.flag = {.code = FlagCode::scale,
                   .subject = object.name,
                   .value = value_m,
                   .limit = limit_m,
                   .unit = "m",
                   .text = std::move(text)}};
}

/// Returns the box around all points of a recording, the body's and others.
Eigen::AlignedBox3d box_of(const RecordedPoints& points) {
  Eigen::AlignedBox3d box;
  for (const Vec3& point : points.position.values) {
    if (is_known(point)) box.extend(point);
  }
  return box;
}

double nearest_distance_m(const SceneObject& object, const Eigen::AlignedBox3d& body) {
  double nearest = kInfinity;
  for (const Vec3& position : object.position) {
    if (is_known(position)) nearest = std::min(nearest, body.exteriorDistance(position));
  }
  return std::isfinite(nearest) ? nearest : 0;
}

}  // namespace

std::vector<Doubt> check_objects(const Demonstration& recording, const AuditInput& /*input*/) {
  if (recording.objects.empty()) return {};
  const Eigen::AlignedBox3d body = box_of(recorded_points(recording.streams, recording.hand));
  std::vector<Doubt> doubts;
  for (const SceneObject& object : recording.objects) {
    const double size_m = bounding_box(object, Pose::Identity()).sizes().maxCoeff();
    const double distance_m = body.isEmpty() ? 0 : nearest_distance_m(object, body);
    if (size_m > kMaxObjectSize_m || size_m < kMinObjectSize_m) {
      doubts.push_back(of_object(
          object, size_m, size_m < kMinObjectSize_m ? kMinObjectSize_m : kMaxObjectSize_m,
          fmt::format("{} would be {:.3g} m large: is it in another unit?", object.name, size_m)));
    }
    if (distance_m > kMaxObjectDistance_m) {
      doubts.push_back(
          of_object(object, distance_m, kMaxObjectDistance_m,
                    fmt::format("{} is never nearer than {:.3g} m to the person: is it "
                                "in another frame or unit?",
                                object.name, distance_m)));
    }
  }
  return doubts;
}

}  // namespace morphe::imports
