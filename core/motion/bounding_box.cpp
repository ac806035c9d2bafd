#include "core/motion/bounding_box.hpp"

namespace morphe {
namespace {

bool size_fits_shape(const SceneObject& object) {
  if (object.shape == Shape::mesh) return !object.vertices.empty();
  const int dimensions = object.shape == Shape::sphere ? 1 : object.shape == Shape::box ? 3 : 2;
  return std::ssize(object.size) == dimensions;
}

/// Returns half the extent of an object that is no mesh along each axis of the frame.
Vec3 half_extent(const SceneObject& object, const Eigen::Matrix3d& rotation) {
  const std::vector<double>& size = object.size;
  const Eigen::Array3d abs_z_axis = rotation.col(2).array().abs();
  if (object.shape == Shape::sphere) return Vec3::Constant(size[0]);
  if (object.shape == Shape::box) return rotation.cwiseAbs() * Vec3(size[0], size[1], size[2]) / 2;
  if (object.shape == Shape::capsule) return size[0] + size[1] / 2 * abs_z_axis;
  // A cylinder's disk of unit normal a extends by r sqrt(1 - a_i^2) along axis i.
  return size[1] / 2 * abs_z_axis + size[0] * (1 - abs_z_axis.square()).max(0).sqrt();
}

}  // namespace

Eigen::AlignedBox3d bounding_box(const SceneObject& object, const Pose& frame_from_object) {
  if (!size_fits_shape(object)) return Eigen::AlignedBox3d(frame_from_object.translation());
  Eigen::AlignedBox3d extent;
  for (const Vec3& vertex : object.vertices) extent.extend(frame_from_object * vertex);
  if (object.shape == Shape::mesh) return extent;
  const Vec3 centre = frame_from_object.translation();
  const Vec3 half = half_extent(object, frame_from_object.linear());
  return {centre - half, centre + half};
}

}  // namespace morphe
