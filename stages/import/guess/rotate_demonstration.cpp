#include "stages/import/guess/rotate_demonstration.hpp"

#include <optional>

namespace morphe::imports {
namespace {

struct DemonstrationRotation {
  Quat by;
  void operator()(Vec3& point) const { point = by * point; }
  void operator()(Quat& rotation) const { rotation = by * rotation; }
  template <class Values>
  void all(Values& values) const {
    for (auto& value : values) (*this)(value);
  }
  void bodies(std::optional<BodyStream>& stream) const {
    if (!stream) return;
    all(stream->position.values);
    all(stream->orientation.values);
  }
  void streams(Streams& of) const {
    if (of.markers) all(of.markers->position.values);
    bodies(of.sensors);
    bodies(of.skeleton);
    if (of.hand && of.hand->kind == HandKind::fingertips) all(of.hand->position.values);
  }
};

}  // namespace

void rotate_about_vertical(Demonstration& demonstration, double angle) {
  const DemonstrationRotation turn{Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ()))};
  turn.streams(demonstration.streams);
  turn.streams(demonstration.calibration);
  for (SceneObject& object : demonstration.objects) {
    turn.all(object.position);
    turn.all(object.orientation);
  }
}

}  // namespace morphe::imports
