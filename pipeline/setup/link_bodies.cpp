#include "pipeline/setup/link_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace morphe::setup {
namespace {

constexpr int kFacets = 96;  ///< of a circle: they stand off it by 1 / cos(pi / 96) - 1 = 0.054 %
/// Points on which the depth of an overlap is measured, beside the corners: chosen by hand, one
/// every 6 mm on a palm of 250 cm^2.
constexpr int kDepthSamples = 700;

SceneObject capsule_shape(const RobotModel::Capsule& capsule) {
  SceneObject object;
  object.shape = Shape::capsule;
  object.size = {capsule.radius, (capsule.to - capsule.from).norm()};
  object.position = {0.5 * (capsule.from + capsule.to)};
  object.orientation = {capsule.from == capsule.to
                            ? Quat::Identity()
                            : Quat::FromTwoVectors(Vec3::UnitZ(), capsule.to - capsule.from)};
  return object;
}

LinkBody body_of(const std::vector<SceneObject>& shapes, bool assumed, const std::string& name) {
  std::vector<cover::Triangle> triangles = cover::surface_of(shapes, kFacets);
  std::vector<Vec3> surface = cover::sample_area(triangles, kDepthSamples, name + "/depth");
  for (const Vec3& corner : cover::outermost_corners(triangles)) surface.push_back(corner);
  double radius_m = 0;
  for (const cover::Triangle& t : triangles)
    radius_m = std::max({radius_m, t.a.norm(), t.b.norm(), t.c.norm()});
  collision::MeshBody mesh(cover::mesh_of(triangles));
  return {std::move(mesh), std::move(triangles), std::move(surface), radius_m, assumed};
}

}  // namespace

LinkBodies link_bodies(const std::map<int, std::vector<SceneObject>>& shapes_by_frame,
                       const RobotModel& robot) {
  std::map<int, std::vector<SceneObject>> capsules;
  for (const RobotModel::Capsule& capsule : robot.capsules)
    capsules[capsule.frame].push_back(capsule_shape(capsule));
  LinkBodies bodies;
  for (const auto& [frame, own] : capsules) {
    const auto real = shapes_by_frame.find(frame);
    const bool assumed = real == shapes_by_frame.end() || real->second.empty();
    const std::string name = frame < 0 ? "base" : robot.frames[frame].name;
    bodies.emplace(frame, body_of(assumed ? own : real->second, assumed, name));
  }
  return bodies;
}

double overlap_depth_m(const LinkBody& one, const LinkBody& other, const Pose& one_from_other) {
  const Pose other_from_one = one_from_other.inverse();
  double depth_m = 0;
  for (const Vec3& point : other.surface)
    depth_m = std::max(depth_m, one.mesh.depth(one_from_other * point));
  for (const Vec3& point : one.surface)
    depth_m = std::max(depth_m, other.mesh.depth(other_from_one * point));
  return depth_m;
}

}  // namespace morphe::setup
