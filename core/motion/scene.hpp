#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/export.hpp"
#include "core/motion/geometry.hpp"
#include "core/motion/named.hpp"

namespace morphe {

enum class Shape { sphere, box, cylinder, capsule, mesh };
constexpr std::array<std::string_view, 5> names_of(Shape) {
  return {"sphere", "box", "cylinder", "capsule", "mesh"};
}

/// A body of the world. Poses are those of the body's centre; cylinder and capsule lie along z.
/// size: sphere {r}; box {full x, y, z}; cylinder and capsule {r, length along z} (a capsule's
/// length is that of its straight part); mesh {} with vertices and triangles.
struct SceneObject {
  std::string name;
  Shape shape = Shape::box;
  std::vector<double> size;       ///< [m]
  std::vector<double> time;       ///< [K] demonstration time [s]; K = 1: fixed
  std::vector<Vec3> position;     ///< [K] [m]
  std::vector<Quat> orientation;  ///< [K]
  std::vector<Vec3> vertices;     ///< mesh only
  std::vector<Eigen::Vector3i> triangles;
  std::string attached_frame;   ///< robot frame that carries it, "" if none
  double attach_s = kNotSeen;   ///< carried from here …
  double release_s = kNotSeen;  ///< … to here [demonstration time, s]
};

struct Scene {
  std::vector<SceneObject> objects;
};

/// The first object of that name, null if there is none.
MORPHE_EXPORT const SceneObject* object_named(const std::vector<SceneObject>& objects,
                                              const std::string& name);
MORPHE_EXPORT SceneObject* object_named(std::vector<SceneObject>& objects, const std::string& name);

/// Pose of an object at a demonstration time, as recorded: linear in position, slerp in
/// orientation, held before the first and after the last sample. Attachment is not considered.
MORPHE_EXPORT Pose recorded_pose(const SceneObject& object, double time_s);

}  // namespace morphe
