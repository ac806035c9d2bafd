#include "core/motion/bounding_box.hpp"

#include <array>
#include <cstddef>

namespace morphe {
namespace {

bool has_size(const SceneObject& object) {
  // Sphere, box, cylinder, capsule.
  constexpr std::array<std::size_t, 4> kSizeCounts = {1, 3, 2, 2};
  if (object.shape == Shape::mesh) return !object.vertices.empty();
  return object.size.size() == kSizeCounts[static_cast<std::size_t>(object.shape)];
}

/// Returns half the extent along each axis of a frame, about the object's centre. Meshes are not
/// supported.
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

Eigen::AlignedBox3d bounding_box(const SceneObject& object, const Pose& frame_from_object) {
  if (!has_size(object)) return Eigen::AlignedBox3d(frame_from_object.translation());
  Eigen::AlignedBox3d extent;
  for (const Vec3& vertex : object.vertices) extent.extend(frame_from_object * vertex);
  if (object.shape == Shape::mesh) return extent;
  const Vec3 centre = frame_from_object.translation();
  const Vec3 half = half_extent(object, frame_from_object.linear());
  return {centre - half, centre + half};
}

}  // namespace morphe
