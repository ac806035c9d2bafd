#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/collision/mesh_solid.hpp"
#include "core/config/node.hpp"
#include "core/motion/scene.hpp"

namespace morphe::scene {

/// What an object's place is given relative to, where it stands as the movement begins:
///   world     the recording's frame: X right, Y forward, Z up, origin as in the recording
///   table     centre of the table's top, its axes: those of the world, if it is inferred
///   target    centre and axes of the object that is grasped
///   shoulder  the person's, axes of the world
///   base      the robot's base
enum class Relative { world, table, target, shoulder, base };
constexpr std::array<std::string_view, 5> names_of(Relative) {
  return {"world", "table", "target", "shoulder", "base"};
}

/// Which point of an object is where its `position` says: its own origin (a shape's centre, what a
/// file's numbers count from), or its foot, once it is turned: the middle of its extent in x and y,
/// its lowest point in z.
enum class Anchor { origin, foot };
constexpr std::array<std::string_view, 2> names_of(Anchor) { return {"origin", "foot"}; }

/// A fixed body.
struct ConfiguredObject {
  std::string name;
  std::string shape = "box";  ///< sphere | box | cylinder | capsule | convex | mesh
  std::vector<double> size;   ///< sphere: r; box: x y z; cylinder, capsule: r, length [m]
  std::string file;           ///< STL or OBJ of a mesh, relative to where it is named; convex:
                              ///< its hull
  double scale = 1;           ///< of the file's numbers: 0.001 if they are mm
  Relative relative_to = Relative::world;  ///< the frame of position and rpy
  Anchor anchor = Anchor::origin;          ///< the point that position is of
  Vec3 position = Vec3::Zero();            ///< [m]
  Vec3 rpy = Vec3::Zero();                 ///< Rz(yaw) Ry(pitch) Rx(roll) [rad]
  bool in_mapping = true;                  ///< the mapping's clearance term knows it

  SceneObject mesh;  ///< what `file` holds, filled in by load_scene_files()
};
template <class Fields>
void fields(Fields& f, ConfiguredObject& o) {
  f.required("name", o.name);
  f.required("shape", o.shape);
  f("size", o.size);
  f("file", o.file);
  f("scale", o.scale);
  f("relative_to", o.relative_to);
  f("anchor", o.anchor);
  f.required("position", o.position);
  f("rpy", o.rpy);
  f("in_mapping", o.in_mapping);
}
std::string why_invalid(const ConfiguredObject& object);

/// The box "table". Nobody records the table, but hands rest on it: its height is taken from the
/// lowest fingertips.
struct TableOptions {
  bool infer = true;             ///< false without `height`: no table
  std::optional<double> height;  ///< of its top; overrides what is inferred [m]
  double low_percentile = 5;     ///< the tips' resting height: this percentile of all heights
                                 ///< in the recording, so that one stray sample does not count
  double tip_clearance = 0.012;  ///< a tip goal is the finger's axis: the top lies at least
                                 ///< this far below the resting height and below every tip goal
                                 ///< that is planned (the robot's finger radius 0.011, and a
                                 ///< millimetre to spare) [m]
  double thickness = 0.04;       ///< thin, so that nothing can be deep inside unnoticed, and
                                 ///< thick enough that a finger cannot pass in one sample [m]
  std::vector<double> size = {1.2, 0.8};  ///< least extent in x, y; grows all ways but the front
  double front_margin = 0.05;  ///< the front edge lies this far before the hand (wrist or
                               ///< tips, whichever is nearer to the chest) at the start: the
                               ///< elbow hangs beside the table, not over it [m]
  double side_margin = 0.15;   ///< the table goes on this far beyond the planned tips [m]
};
template <class Fields>
void fields(Fields& f, TableOptions& o) {
  f("infer", o.infer);
  f("height", o.height);
  f("low_percentile", o.low_percentile);
  f("tip_clearance", o.tip_clearance);
  f("thickness", o.thickness);
  f("size", o.size);
  f("front_margin", o.front_margin);
  f("side_margin", o.side_margin);
}
std::string why_invalid(const TableOptions& options);

/// Where the target stands instead of where it stood: see stages/scene/move_target.hpp.
struct TargetPlacement {
  Vec3 position = Vec3::Zero();  ///< of its centre where the grasp begins, in the world [m]
  Vec3 rpy = Vec3::Zero();       ///< of its frame in the world, Rz(yaw) Ry(pitch) Rx(roll) [rad]
};
template <class Fields>
void fields(Fields& f, TargetPlacement& o) {
  f.required("position", o.position);
  f("rpy", o.rpy);
}
/// The same relative to where it stood: shifted, and turned about its centre.
struct TargetMove {
  Vec3 position = Vec3::Zero();  ///< along the world's axes [m]
  Vec3 rpy = Vec3::Zero();       ///< about the world's axes [rad]
};
template <class Fields>
void fields(Fields& f, TargetMove& o) {
  f("position", o.position);
  f("rpy", o.rpy);
}

/// The shape of the target, where it is known. It stands on the table, between thumb and index tip
/// at the grasp. A recorded target gets it too, in its recorded frame: held_at and rpy are for one
/// that was not recorded.
struct TargetBody {
  std::string shape = "mesh";   ///< as of a ConfiguredObject
  std::vector<double> size;     ///< likewise [m]
  std::string file;             ///< likewise
  double scale = 1;             ///< likewise
  Vec3 rpy = Vec3::Zero();      ///< of its frame in the world, Rz(yaw) Ry(pitch) Rx(roll) [rad]
  std::vector<double> held_at;  ///< x, y of the point of its own frame below the middle between the
                                ///< tips; empty: the middle of its extent, once it is turned [m]

  SceneObject mesh;  ///< what `file` holds, filled in by load_scene_files()
};
template <class Fields>
void fields(Fields& f, TargetBody& o) {
  f("shape", o.shape);
  f("size", o.size);
  f("file", o.file);
  f("scale", o.scale);
  f("rpy", o.rpy);
  f("held_at", o.held_at);
}
std::string why_invalid(const TargetBody& body);

/// What carries the target from its grasp to its release: thumb and index, or the palm.
enum class Carrier { fingers, palm };
constexpr std::array<std::string_view, 2> names_of(Carrier) { return {"fingers", "palm"}; }

/// The object that is grasped, if it was not recorded: an upright cylinder on the table, its axis
/// midway between thumb and index tip.
struct TargetOptions {
  bool infer = true;
  std::string name = "cup";
  double height = 0.10;      ///< grows to `rim` above the tips: they hold the side, not the rim [m]
  double rim = 0.02;         ///< [m]
  double pad_depth = 0.011;  ///< goals are finger axes: radius = half the tips' horizontal distance
                             ///< less the robot's fingertip radius, so that surfaces meet [m]
  double min_radius = 0.015;              ///< [m]
  double max_radius = 0.060;              ///< [m]
  std::optional<double> radius;           ///< overrides what is inferred [m]
  std::optional<TargetBody> body;         ///< its shape, instead of the cylinder
  Carrier carried = Carrier::fingers;     ///< from the grasp to its release
  TargetMove moved;                       ///< recorded or inferred, it stands elsewhere
  std::optional<TargetPlacement> placed;  ///< likewise
};
template <class Fields>
void fields(Fields& f, TargetOptions& o) {
  f("infer", o.infer);
  f("name", o.name);
  f("height", o.height);
  f("rim", o.rim);
  f("pad_depth", o.pad_depth);
  f("min_radius", o.min_radius);
  f("max_radius", o.max_radius);
  f("radius", o.radius);
  f("body", o.body);
  f("carried", o.carried);
  f("moved", o.moved);
  f("placed", o.placed);
}
std::string why_invalid(const TargetOptions& options);

struct SceneOptions {
  std::string file;                       ///< YAML with more `objects`, relative to the config;
                                          ///< or a MoveIt planning scene in the recording's world
  std::vector<ConfiguredObject> objects;  ///< fixed bodies
  TableOptions table;
  TargetOptions target;
  bool other_arm = false;  ///< the person's other arm is an obstacle, see other_arm.hpp
  /// Of its upper arm, forearm and hand [m]: those of a strong man, about the 95th percentile of
  /// the men of ANSUR II (Gordon et al. 2014): flexed circumferences of 0.41 and 0.35 m over 2 pi,
  /// half of a hand's breadth of 0.095 m.
  std::vector<double> other_arm_radii = {0.065, 0.055, 0.048};
  /// Filled in by load_scene_files(): the objects of `file`, and all meshes made ready.
  std::vector<ConfiguredObject> file_objects;
  collision::ReadyMeshes meshes;
};
template <class Fields>
void fields(Fields& f, SceneOptions& o) {
  f("file", o.file);
  f("objects", o.objects);
  f("table", o.table);
  f("target", o.target);
  f("other_arm", o.other_arm);
  f("other_arm_radii", o.other_arm_radii);
}
std::string why_invalid(const SceneOptions& options);

/// For options that were read from `node`: loads the meshes and `file` (if any). InputError for a
/// wrong value (with file, line and key), a name used twice, a file that cannot be read, a mesh
/// that is none.
void load_scene_files(SceneOptions& options, const config::ConfigNode& node);

}  // namespace morphe::scene
