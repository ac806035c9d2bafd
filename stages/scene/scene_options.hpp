#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/collision/mesh_solid.hpp"
#include "core/config/node.hpp"
#include "core/motion/key_bounds.hpp"
#include "core/motion/scene.hpp"

namespace morphe::scene {

/// The frame that an object's pose is relative to. A frame that moves is taken where it is when the
/// movement begins.
///   world     the recording's frame: X right, Y forward, Z up, origin as in the recording
///   table     centre and axes of the table's top; the axes are the world's if it is inferred
///   target    centre and axes of the grasped object
///   shoulder  the person's shoulder, axes of the world
///   base      the robot's base
enum class ReferenceFrame { world, table, target, shoulder, base };
/// Returns the names of the frames in configurations.
constexpr std::array<std::string_view, 5> names_of(ReferenceFrame) {
  return {"world", "table", "target", "shoulder", "base"};
}

/// The point of an object that `position` refers to:
///   origin         the centre of a shape, or the origin of a file's coordinates
///   bottom_centre  in its final orientation, the middle of its extent in x and y at its lowest z
enum class Anchor { origin, bottom_centre };
/// Returns the names of the anchors in configurations.
constexpr std::array<std::string_view, 2> names_of(Anchor) { return {"origin", "bottom_centre"}; }

/// A fixed object of the configuration.
struct ConfiguredObject {
  std::string name;           ///< unique
  std::string shape = "box";  ///< sphere | box | cylinder | capsule | convex | mesh
  std::vector<double> size;   ///< sphere: r; box: x y z; cylinder, capsule: r, length [m]
  /// STL or OBJ file of a mesh, relative to the file that names it; for convex, the hull is used.
  std::string file;
  double scale = 1;  ///< unit of the file's coordinates in m: 0.001 if they are mm
  ReferenceFrame relative_to = ReferenceFrame::world;  ///< the frame of position and rpy
  Anchor anchor = Anchor::origin;                      ///< the point that `position` refers to
  Vec3 position = Vec3::Zero();                        ///< position of the anchor [m]
  Vec3 rpy = Vec3::Zero();                             ///< Rz(yaw) Ry(pitch) Rx(roll) [rad]
  bool avoid_in_mapping = true;  ///< true if the mapping's clearance term includes it

  SceneObject mesh;  ///< read from `file` by load_scene_files()
};
template <class Fields>
void fields(Fields& f, ConfiguredObject& o) {
  f.required("name", o.name);
  f.required("shape", o.shape);
  f("size", o.size, bounds::kObjectSize);
  f("file", o.file);
  f("scale", o.scale, bounds::kMeshScale);
  f("relative_to", o.relative_to);
  f("anchor", o.anchor);
  f.required("position", o.position, bounds::kCoordinate);
  f("rpy", o.rpy, bounds::kAngle);
  f("avoid_in_mapping", o.avoid_in_mapping);
}
/// Returns a sentence about the first invalid field, or "" if all are valid.
std::string validation_error(const ConfiguredObject& object);

/// Options of the box "table". Tables are not recorded, but hands rest on them: the height is
/// inferred from the lowest fingertips.
struct TableOptions {
  bool infer = true;             ///< false without `height` disables the table
  std::optional<double> height;  ///< height of its top; overrides the inferred height [m]
  /// The tips' resting height is this percentile of the heights of all tips in the recording, so
  /// that a single outlier has no effect.
  double resting_height_percentile = 5;
  /// Least distance of the top below the resting height and below every planned tip goal, since a
  /// tip goal is on the finger's axis (the robot's finger radius 0.011 plus a millimetre) [m].
  double tip_clearance = 0.012;
  /// Thin, so that deep penetration is detected, and thick enough that a finger cannot pass through
  /// it between two samples [m].
  double thickness = 0.04;
  std::vector<double> size = {1.2, 0.8};  ///< least extent in x, y; the front edge does not move
  /// Distance of the front edge before the hand (wrist or tips, whichever is nearer to the chest)
  /// at the start, so that the elbow hangs beside the table, not above it [m].
  double front_margin = 0.05;
  double side_margin = 0.15;  ///< extent of the table beyond the planned tips [m]
};
template <class Fields>
void fields(Fields& f, TableOptions& o) {
  f("infer", o.infer);
  f("height", o.height, bounds::kCoordinate);
  f("resting_height_percentile", o.resting_height_percentile, bounds::kPercentile);
  f("tip_clearance", o.tip_clearance, bounds::kLength);
  f("thickness", o.thickness, bounds::kPositiveLength);
  f("size", o.size, bounds::kObjectSize);
  f("front_margin", o.front_margin, bounds::kSignedLength);
  f("side_margin", o.side_margin, bounds::kLength);
}
/// Returns a sentence about the first invalid option, or "" if all are valid.
std::string validation_error(const TableOptions& options);

/// A pose of the target that replaces the recorded one: see stages/scene/move_target.hpp.
struct TargetPose {
  Vec3 position = Vec3::Zero();  ///< of its centre at the start of the grasp, in the world [m]
  Vec3 rpy = Vec3::Zero();       ///< of its frame in the world, Rz(yaw) Ry(pitch) Rx(roll) [rad]
};
template <class Fields>
void fields(Fields& f, TargetPose& o) {
  f.required("position", o.position, bounds::kCoordinate);
  f("rpy", o.rpy, bounds::kAngle);
}
/// A displacement of the target from its recorded pose; the rotation is about its centre.
struct TargetPoseOffset {
  Vec3 position = Vec3::Zero();  ///< translation along the world's axes [m]
  Vec3 rpy = Vec3::Zero();       ///< rotation about the world's axes [rad]
};
template <class Fields>
void fields(Fields& f, TargetPoseOffset& o) {
  f("position", o.position, bounds::kCoordinate);
  f("rpy", o.rpy, bounds::kAngle);
}

/// The shape of the target, if it is known. It is placed on the table, between thumb and index tip
/// at the grasp. A recorded target gets this shape too, in its recorded frame; grasp_point and rpy
/// apply only to a target that was not recorded.
struct TargetBody {
  std::string shape = "mesh";  ///< shape, size, file and scale as of a ConfiguredObject
  std::vector<double> size;
  std::string file;
  double scale = 1;
  Vec3 rpy = Vec3::Zero();  ///< of its frame in the world, Rz(yaw) Ry(pitch) Rx(roll) [rad]
  /// x, y, in its own frame, of the point that is placed below the midpoint between the tips [m];
  /// if empty, this is the middle of its extent in its final orientation.
  std::vector<double> grasp_point;

  SceneObject mesh;  ///< read from `file` by load_scene_files()
};
template <class Fields>
void fields(Fields& f, TargetBody& o) {
  f("shape", o.shape);
  f("size", o.size, bounds::kObjectSize);
  f("file", o.file);
  f("scale", o.scale, bounds::kMeshScale);
  f("rpy", o.rpy, bounds::kAngle);
  f("grasp_point", o.grasp_point, bounds::kCoordinate);
}
/// Returns a sentence about the first invalid field, or "" if all are valid.
std::string validation_error(const TargetBody& body);

/// The link to which the target is attached from its grasp to its release.
enum class Carrier { fingers, palm };
/// Returns the names of the carriers in configurations.
constexpr std::array<std::string_view, 2> names_of(Carrier) { return {"fingers", "palm"}; }

/// Options of the grasped object, if it was not recorded: an upright cylinder on the table with its
/// axis midway between thumb and index tip.
struct TargetOptions {
  bool infer = true;         ///< true if a target that was not recorded is inferred
  std::string name = "cup";  ///< of the inferred target
  /// Height; increased to `rim_margin` above the tips, since they hold the side, not the rim [m].
  double height = 0.10;
  double rim_margin = 0.02;  ///< distance of the rim above the higher tip [m]
  /// The robot's fingertip radius [m]. Goals are on the axes of the fingers; the target's radius is
  /// half the tips' horizontal distance less `pad_depth`, so that the surfaces touch.
  double pad_depth = 0.011;
  double min_radius = 0.015, max_radius = 0.060;  ///< [m]
  std::optional<double> radius;                   ///< overrides the inferred radius [m]
  std::optional<TargetBody> body;                 ///< shape that replaces the cylinder
  Carrier carried_by = Carrier::fingers;  ///< link that carries it from the grasp to its release
  TargetPoseOffset pose_offset;           ///< displacement of the recorded or inferred target
  std::optional<TargetPose> pose;         ///< the same as a pose, instead of `pose_offset`
};
template <class Fields>
void fields(Fields& f, TargetOptions& o) {
  f("infer", o.infer);
  f("name", o.name);
  f("height", o.height, bounds::kInferredExtent);
  f("rim_margin", o.rim_margin, bounds::kLength);
  f("pad_depth", o.pad_depth, bounds::kLength);
  f("min_radius", o.min_radius, bounds::kInferredRadius);
  f("max_radius", o.max_radius, bounds::kInferredRadius);
  f("radius", o.radius, bounds::kPositiveLength);
  f("body", o.body);
  f("carried_by", o.carried_by);
  f("pose_offset", o.pose_offset);
  f("pose", o.pose);
}
/// Returns a sentence about the first invalid option, or "" if all are valid.
std::string validation_error(const TargetOptions& options);

/// Options of the scene (config section `scene`).
struct SceneOptions {
  /// YAML file with further `objects`, relative to the config, or a MoveIt planning scene in the
  /// recording's world.
  std::string file;
  std::vector<ConfiguredObject> objects;
  TableOptions table;
  TargetOptions target;
  bool other_arm = false;  ///< true if the person's other arm is an obstacle, see other_arm.hpp
  /// Radii of its upper arm, forearm and hand [m]. These are of a strong man, about the 95th
  /// percentile of the men of ANSUR II (Gordon et al. 2014): flexed circumferences of 0.41 m and
  /// 0.35 m, each over 2π, and half of the hand's breadth of 0.095 m.
  std::vector<double> other_arm_radii = {0.065, 0.055, 0.048};

  std::vector<ConfiguredObject> file_objects;  ///< those of `file`, read by load_scene_files()
  collision::MeshCache meshes;                 ///< preprocessed by load_scene_files()
  /// The files read by load_scene_files(): `file`, the meshes, and the files that meshes name.
  std::vector<std::filesystem::path> files;
};
template <class Fields>
void fields(Fields& f, SceneOptions& o) {
  f("file", o.file);
  f("objects", o.objects);
  f("table", o.table);
  f("target", o.target);
  f("other_arm", o.other_arm);
  f("other_arm_radii", o.other_arm_radii, bounds::kPositiveLength);
}
/// Returns a sentence about the first invalid option, or "" if all are valid.
std::string validation_error(const SceneOptions& options);

/// Returns the objects of the configuration, then those of its file.
std::vector<const ConfiguredObject*> configured_objects(const SceneOptions& options);

/// Names of the capsules of the person's other arm.
inline constexpr std::array<const char*, 3> kOtherArmNames = {"other upper arm", "other forearm",
                                                              "other hand"};
/// Returns true if an object of that name is a part of the other arm under these options.
bool is_other_arm_part(const SceneOptions& options, const std::string& name);

/// Loads the meshes and `file` (if any) of options that were read from `node`, from the disk or
/// from the given files of the node's document (core/files/given_files.hpp). Throws InputError
/// (with file, line and key) for a wrong value, a name used twice, and a file that cannot be read,
/// is not a mesh or has a size that indicates another unit.
void load_scene_files(SceneOptions& options, const config::ConfigNode& node);

}  // namespace morphe::scene
