#include "stages/import/guess/rotate_demonstration.hpp"

#include <optional>

namespace morphe::imports {
namespace {

struct DemonstrationRotation {
  Quat rotation;
  void operator()(Vec3& point) const { point = rotation * point; }
  void operator()(Quat& orientation) const { orientation = rotation * orientation; }
  template <class Values>
  void all(Values& values) const {
    for (auto& value : values) (*this)(value);
  }
  void bodies(std::optional<BodyStream>& stream) const {
    if (!stream) return;
    all(stream->position.values);
    all(stream->orientation.values);
  }
  void operator()(Streams& streams) const {
    if (streams.markers) all(streams.markers->position.values);
    bodies(streams.sensors);
    bodies(streams.skeleton);
    auto& hand = streams.hand;
    if (hand && hand->kind == HandKind::fingertips) all(hand->position.values);
  }
};

}  // namespace

void rotate_about_vertical(Demonstration& demonstration, double angle_rad) {
  const DemonstrationRotation rotate{Quat(Eigen::AngleAxisd(angle_rad, Vec3::UnitZ()))};
  rotate(demonstration.streams);
  rotate(demonstration.calibration);
  for (SceneObject& object : demonstration.objects) {
    rotate.all(object.position);
    rotate.all(object.orientation);
  }
}

}  // namespace morphe::imports
