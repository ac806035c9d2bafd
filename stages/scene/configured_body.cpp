#include "stages/scene/configured_body.hpp"

#include "core/motion/bounding_box.hpp"

namespace morphe::scene {
namespace {

void set_shape(const std::string& shape, const std::vector<double>& size, const SceneObject& mesh,
               SceneObject& object) {
  const bool is_mesh = !mesh.vertices.empty();
  object.shape = is_mesh ? Shape::mesh : enum_from_name<Shape>(shape).value_or(mesh.shape);
  object.size = is_mesh ? std::vector<double>() : size;
  object.vertices = mesh.vertices;
  object.triangles = mesh.triangles;
}

/// Returns the vector from the object's origin to its anchor, after the rotation.
Vec3 anchor_of(const SceneObject& object, Anchor anchor, const Quat& rotation) {
  if (anchor == Anchor::origin) return Vec3::Zero();
  const Eigen::AlignedBox3d extent = bounding_box(object, make_pose(Vec3::Zero(), rotation));
  return {extent.center().x(), extent.center().y(), extent.min().z()};
}

}  // namespace

Quat rotation_from_rpy(const Vec3& rpy) {
  return Quat(Eigen::AngleAxisd(rpy.z(), Vec3::UnitZ()) *
              Eigen::AngleAxisd(rpy.y(), Vec3::UnitY()) *
              Eigen::AngleAxisd(rpy.x(), Vec3::UnitX()));
}

SceneObject configured_body(const ConfiguredObject& configured, double time_s) {
  SceneObject object;
  object.name = configured.name;
  set_shape(configured.shape, configured.size, configured.mesh, object);
  const Quat rotation = rotation_from_rpy(configured.rpy);
  object.time = {time_s};
  object.position = {configured.position - anchor_of(object, configured.anchor, rotation)};
  object.orientation = {rotation};
  object.pose_origin = object.shape_origin = ObjectOrigin::configured;
  return object;
}

void set_shape(const TargetBody& body, SceneObject& object) {
  set_shape(body.shape, body.size, body.mesh, object);
  object.shape_origin = ObjectOrigin::configured;
}

}  // namespace morphe::scene
