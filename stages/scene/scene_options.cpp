#include "stages/scene/scene_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/collision/mesh_file.hpp"
#include "core/config/fields.hpp"
#include "core/files/item_name.hpp"
#include "core/motion/bounding_box.hpp"
#include "core/motion/count_with_noun.hpp"
#include "core/moveit/planning_scene.hpp"
#include "stages/scene/infer_objects.hpp"
#include "stages/scene/scene_schema.hpp"

namespace morphe::scene {
namespace {

struct SceneFile {
  std::vector<ConfiguredObject> objects;
};
template <class Fields>
void fields(Fields& f, SceneFile& o) {
  f.required("objects", o.objects);
}

/// Limits of the longest side of a mesh, beyond which its unit is probably wrong.
constexpr double kLargestObject_m = 5, kLargestTarget_m = 0.5, kSmallestMesh_m = 0.0005;

std::string mesh_size_error(const std::string& file, const SceneObject& mesh, double scale,
                            bool scale_given, double largest_m) {
  const double length_m = bounding_box(mesh, Pose::Identity()).sizes().maxCoeff();
  if (!scale_given && length_m > largest_m) {
    return fmt::format(
        "{} is {:.4g} m long: give scale: 0.001 if its numbers are mm ({:.4g} m), scale: 0.0254 if "
        "they are inches ({:.4g} m), scale: 1 if they are m",
        file, length_m, 0.001 * length_m, 0.0254 * length_m);
  }
  if (scale != 1 && length_m < kSmallestMesh_m) {
    return fmt::format("{} is {:.2g} mm long with scale: {}: omit scale if its numbers are m", file,
                       1e3 * length_m, scale);
  }
  return "";
}

using Files = std::vector<std::filesystem::path>;

/// Loads the mesh of options with shape, file, scale and mesh, read from `node`. Appends to `read`
/// the files that were read.
template <class Options>
void load_mesh_of(const config::ConfigNode& node, double largest_m, Options& options, Files& read) {
  if (options.file.empty()) return;
  const config::ConfigNode file = node["file"];
  collision::MeshSource source{file.given(), {}};
  std::string error = collision::load_mesh(file.folder() / options.file, options.scale,
                                           options.shape == "convex", options.mesh, &source);
  read.insert(read.end(), source.read.begin(), source.read.end());
  if (error.empty()) {
    error =
        mesh_size_error(options.file, options.mesh, options.scale, node.has("scale"), largest_m);
  }
  if (!error.empty()) file.fail(error);
}

void load_meshes(const config::ConfigNode& list, std::vector<ConfiguredObject>& objects,
                 Files& read) {
  const std::vector<config::ConfigNode> nodes = list.items();
  for (int k = 0; k < std::ssize(objects); ++k)
    load_mesh_of(nodes[k], kLargestObject_m, objects[k], read);
}

std::vector<ConfiguredObject> moveit_objects(const config::ConfigNode& root) {
  std::vector<ConfiguredObject> objects;
  for (const SceneObject& object : moveit::read_moveit_scene(root.file(), root.given()).objects) {
    ConfiguredObject& configured = objects.emplace_back();
    configured.name = object.name;
    configured.shape = name_of(object.shape);
    configured.size = object.size;
    configured.position = object.position.front();
    configured.rpy = object.orientation.front().toRotationMatrix().eulerAngles(2, 1, 0).reverse();
    configured.mesh = object;
  }
  return objects;
}

/// Returns the error in shape, size, file and scale, or "".
template <class Options>
std::string shape_error(const Options& o) {
  if (o.shape == "mesh" || o.shape == "convex") {
    if (o.file.empty()) return fmt::format("file: required for a {}", o.shape);
    if (!o.size.empty())
      return fmt::format("size: not allowed for a {}, which has the size of its file", o.shape);
    return "";
  }
  const std::optional<Shape> shape = enum_from_name<Shape>(o.shape);
  if (!shape) {
    return fmt::format("shape: must be sphere, box, cylinder, capsule, convex or mesh, not '{}'",
                       o.shape);
  }
  if (!o.file.empty()) return fmt::format("file: not allowed for a {}", o.shape);
  const std::size_t count = *shape == Shape::sphere ? 1 : *shape == Shape::box ? 3 : 2;
  if (o.size.size() != count) {
    return fmt::format("size: a {} needs {}, not {}", o.shape, count_with_noun(count, "number"),
                       o.size.size());
  }
  return "";
}

}  // namespace

config::Schema scene_schema(const config::KeyDescriptions& meanings) {
  return config::schema_of<SceneFile>(meanings);
}

std::string validation_error(const ConfiguredObject& o) {
  if (!files::is_item_name(o.name)) return fmt::format("name: {}", files::kItemNameError);
  if (o.name == "table") return "name: 'table' is the table of scene.table";
  return shape_error(o);
}

std::string validation_error(const TargetBody& o) {
  if (!o.grasp_point.empty() && o.grasp_point.size() != 2)
    return fmt::format("grasp_point: needs x and y, not {} numbers", o.grasp_point.size());
  return shape_error(o);
}

std::string validation_error(const TableOptions& o) {
  if (o.size.size() != 2) return fmt::format("size: needs x and y, not {} numbers", o.size.size());
  return "";
}

std::string validation_error(const TargetOptions& o) {
  if (!files::is_item_name(o.name)) return fmt::format("name: {}", files::kItemNameError);
  if (o.name == "table") return "name: 'table' is the table of scene.table";
  if (o.max_radius < o.min_radius) return "max_radius: must not be below min_radius";
  if (o.radius && o.body) return "radius: not allowed together with body, which has its own size";
  if (o.pose && (o.pose_offset.position != Vec3::Zero() || o.pose_offset.rpy != Vec3::Zero()))
    return "pose: not allowed together with pose_offset";
  return "";
}

std::vector<const ConfiguredObject*> configured_objects(const SceneOptions& options) {
  std::vector<const ConfiguredObject*> objects;
  for (const ConfiguredObject& object : options.objects) objects.push_back(&object);
  for (const ConfiguredObject& object : options.file_objects) objects.push_back(&object);
  return objects;
}

bool is_other_arm_part(const SceneOptions& options, const std::string& name) {
  return options.other_arm && std::ranges::find(kOtherArmNames, name) != kOtherArmNames.end();
}

std::string validation_error(const SceneOptions& o) {
  const std::vector<double>& radii = o.other_arm_radii;
  if (radii.size() != 3)
    return "other_arm_radii: needs three radii: of upper arm, forearm and hand";
  if (is_other_arm_part(o, o.target.name))
    return fmt::format("target: the name '{}' is used by the other arm", o.target.name);
  std::set<std::string> names;
  if (o.target.infer) names.insert(o.target.name);
  for (const ConfiguredObject* object : configured_objects(o)) {
    if (!names.insert(object->name).second || is_other_arm_part(o, object->name))
      return fmt::format("objects: the name '{}' is already used", object->name);
    if (object->relative_to == ReferenceFrame::table && !o.table.infer && !o.table.height) {
      return fmt::format(
          "objects: {} is relative_to: table, but table.infer is false: give table.height, or "
          "another relative_to",
          object->name);
    }
  }
  return "";
}

namespace {

void load_file(SceneOptions& options, const config::ConfigNode& node) {
  options.file_objects.clear();
  if (options.file.empty()) return;
  const config::ConfigNode named = node["file"];
  const config::ConfigNode root =
      config::ConfigNode::load(named.folder() / options.file, named.given());
  options.files.push_back(root.file());
  if (root.has("world")) {
    options.file_objects = moveit_objects(root);
    const bool own_table = options.table.infer || options.table.height;
    for (const ConfiguredObject& object : options.file_objects) {
      if (own_table && object.name == "table")
        root["world"].fail("contains a table: set scene.table.infer to false");
    }
  } else {
    SceneFile file;
    config::read_document(root, file);
    load_meshes(root["objects"], file.objects, options.files);
    options.file_objects = std::move(file.objects);
  }
  if (const std::string error = validation_error(options); !error.empty()) root.fail(error);
}

}  // namespace

void load_scene_files(SceneOptions& options, const config::ConfigNode& node) {
  options.files.clear();
  if (node.has("objects")) load_meshes(node["objects"], options.objects, options.files);
  load_file(options, node);
  options.meshes.clear();
  if (options.target.body) {
    load_mesh_of(node["target"]["body"], kLargestTarget_m, *options.target.body, options.files);
    collision::add_to_cache(options.target.body->mesh, options.meshes);
  }
  for (const ConfiguredObject* object : configured_objects(options))
    collision::add_to_cache(object->mesh, options.meshes);
}

}  // namespace morphe::scene
