#include "stages/scene/configured_body.hpp"
#include "core/motion/bounding_box.hpp"
#include "core/motion/world_frames.hpp"

#include <fmt/format.h>

namespace morphe::scene {
namespace {

void set_shape(const std::string& shape, const std::vector<double>& size, const SceneObject& mesh,
               SceneObject& object) {
  const bool meshed = !mesh.vertices.empty();
  object.shape = meshed ? Shape::mesh : enum_from_name<Shape>(shape).value_or(mesh.shape);
  object.size = meshed ? std::vector<double>() : size;
  object.vertices = mesh.vertices;
  object.triangles = mesh.triangles;
}

Vec3 anchor_of(const SceneObject& object, Anchor anchor, const Quat& turn) {
  if (anchor == Anchor::origin) return Vec3::Zero();
  const Eigen::AlignedBox3d extent = bounding_box(object, make_pose(Vec3::Zero(), turn));
  return {extent.center().x(), extent.center().y(), extent.min().z()};
}

/// Returns the frame that an object is relative to; unseen if it does not exist.
Pose frame_of(ReferenceFrame relative, const WorldFrames& frames) {
  switch (relative) {
    case ReferenceFrame::table:
      return frames.base_from_table;
    case ReferenceFrame::target:
      return frames.base_from_target;
    case ReferenceFrame::shoulder: {
      Pose shoulder = frames.base_from_world;
      shoulder.translation() = frames.shoulder;
      return shoulder;
    }
    case ReferenceFrame::base:
      return Pose::Identity();
    default:
      return frames.base_from_world;
  }
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
  const Quat turn = rotation_from_rpy(configured.rpy);
  object.time = {time_s};
  object.position = {configured.position - anchor_of(object, configured.anchor, turn)};
  object.orientation = {turn};
  return object;
}

void set_shape(const TargetBody& body, SceneObject& object) {
  set_shape(body.shape, body.size, body.mesh, object);
}

std::string add_relative_objects(const SceneOptions& options, const WorldFrames& frames,
                                 double time_s, Scene& scene) {
  for (const auto* list : {&options.objects, &options.file_objects}) {
    for (const ConfiguredObject& configured : *list) {
      if (configured.relative_to == ReferenceFrame::world) continue;
      const Pose base_from_frame = frame_of(configured.relative_to, frames);
      if (!is_known(base_from_frame)) {
        return fmt::format("{} is placed relative to the {}, which does not exist in this movement",
                           configured.name, name_of(configured.relative_to));
      }
      SceneObject& object = scene.objects.emplace_back(configured_body(configured, time_s));
      object.position[0] = base_from_frame * object.position[0];
      object.orientation[0] = (Quat(base_from_frame.linear()) * object.orientation[0]).normalized();
    }
  }
  return "";
}

}  // namespace morphe::scene
