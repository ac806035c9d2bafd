#include "pipeline/motion/scene.hpp"

#include <algorithm>

namespace morphe {
namespace {

/// Half the extent along each of a frame's axes, about the object's centre; of no mesh.
Vec3 half_extent(const SceneObject& object, const Eigen::Matrix3d& turn) {
  const std::vector<double>& size = object.size;
  const Eigen::Array3d along = turn.col(2).array().abs();
  switch (object.shape) {
    case Shape::sphere:
      return Vec3::Constant(size[0]);
    case Shape::box:
      return turn.cwiseAbs() * Vec3(size[0], size[1], size[2]) / 2;
    case Shape::capsule:
      return size[0] + size[1] / 2 * along;
    default:  // a disk of unit normal a reaches r sqrt(1 - a_i^2) along axis i
      return size[1] / 2 * along + size[0] * (1 - along.square()).max(0).sqrt();
  }
}

}  // namespace

Eigen::AlignedBox3d extent_of(const SceneObject& object, const Pose& frame_from_object) {
  Eigen::AlignedBox3d extent;
  for (const Vec3& vertex : object.vertices) extent.extend(frame_from_object * vertex);
  if (object.shape == Shape::mesh) return extent;
  const Vec3 centre = frame_from_object.translation();
  const Vec3 half = half_extent(object, frame_from_object.linear());
  return {centre - half, centre + half};
}

const SceneObject* object_named(const std::vector<SceneObject>& objects, const std::string& name) {
  const auto found = std::ranges::find(objects, name, &SceneObject::name);
  return found == objects.end() ? nullptr : &*found;
}

SceneObject* object_named(std::vector<SceneObject>& objects, const std::string& name) {
  const auto found = std::ranges::find(objects, name, &SceneObject::name);
  return found == objects.end() ? nullptr : &*found;
}

Pose recorded_pose(const SceneObject& object, double time_s) {
  const auto upper = std::upper_bound(object.time.begin(), object.time.end(), time_s);
  const auto after = static_cast<std::size_t>(upper - object.time.begin());
  if (after == 0 || object.time.size() == 1) {
    return make_pose(object.position.front(), object.orientation.front());
  }
  if (after == object.time.size())
    return make_pose(object.position.back(), object.orientation.back());
  const std::size_t before = after - 1;
  const double span_s = object.time[after] - object.time[before];
  const double share = (time_s - object.time[before]) / span_s;
  return make_pose((1 - share) * object.position[before] + share * object.position[after],
                   object.orientation[before].slerp(share, object.orientation[after]));
}

}  // namespace morphe
