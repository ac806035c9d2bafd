#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/enum_names.hpp"
#include "core/motion/export.hpp"
#include "core/motion/geometry.hpp"

namespace morphe {

/// The shape of an object of the scene.
enum class Shape { sphere, box, cylinder, capsule, mesh };
/// Returns the names of the values, in their order.
constexpr std::array<std::string_view, 5> names_of(Shape) {
  return {"sphere", "box", "cylinder", "capsule", "mesh"};
}

/// The origin of an object's pose or shape: the config, the recording, or inference from the hand's
/// motion; `unknown` in files of earlier versions.
enum class ObjectOrigin : std::uint8_t { unknown, configured, recorded, inferred };
/// Returns the names of the values, in their order.
constexpr std::array<std::string_view, 4> names_of(ObjectOrigin) {
  return {"unknown", "configured", "recorded", "inferred"};
}

/// An object of the scene. Poses are those of its centre; cylinders and capsules are aligned with
/// z. size: sphere {r}; box {full x, y, z}; cylinder and capsule {r, length along z} (for a
/// capsule, the length of the cylindrical part); mesh {} with vertices and triangles.
struct SceneObject {
  std::string name;
  Shape shape = Shape::box;
  std::vector<double> size;       ///< [m]
  std::vector<double> time;       ///< [K] demonstration time [s]; K = 1 if it does not move
  std::vector<Vec3> position;     ///< [K] [m]
  std::vector<Quat> orientation;  ///< [K]
  std::vector<Vec3> vertices;     ///< mesh only
  std::vector<Eigen::Vector3i> triangles;
  std::string attached_frame;   ///< robot frame to which it is attached, "" if it is not
  double attach_s = kUnknown;   ///< begin of the attachment [demonstration time, s]
  double release_s = kUnknown;  ///< end of the attachment [demonstration time, s]
  /// Set when a scene is built. The pose of a table is the height of its top.
  ObjectOrigin pose_origin = ObjectOrigin::unknown, shape_origin = ObjectOrigin::unknown;
};

/// The name of the object that is the table.
inline constexpr std::string_view kTableName = "table";

/// Largest distance between the tips and the object that they took [m].
inline constexpr double kMaxTipObjectDistance_m = 0.15;

/// The objects around the robot.
struct Scene {
  std::vector<SceneObject> objects;
};

/// Returns the first object with that name, or null if there is no such object.
MORPHE_EXPORT const SceneObject* find_object(const std::vector<SceneObject>& objects,
                                             const std::string& name);
/// Returns the first object with that name, or null if there is no such object.
MORPHE_EXPORT SceneObject* find_object(std::vector<SceneObject>& objects, const std::string& name);

/// Returns the pose of an object at a demonstration time, from at least one sample: linear in
/// position, slerp in orientation, constant beyond both ends. Attachment is not considered.
MORPHE_EXPORT Pose recorded_pose(const SceneObject& object, double time_s);

}  // namespace morphe
