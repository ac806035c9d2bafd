#include "stages/scene/scene_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/collision/mesh_file.hpp"
#include "core/config/fields.hpp"
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
/// Largest distance from the reference frame, which only coordinates in mm exceed.
constexpr double kMaxPosition_m = 20;

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

/// Loads the mesh of options with shape, file, scale and mesh, read from `node`.
template <class Options>
void load_mesh_of(const config::ConfigNode& node, double largest_m, Options& options) {
  if (options.file.empty()) return;
  const config::ConfigNode file = node["file"];
  std::string error = collision::load_mesh(file.folder() / options.file, options.scale,
                                           options.shape == "convex", options.mesh);
  if (error.empty()) {
    error =
        mesh_size_error(options.file, options.mesh, options.scale, node.has("scale"), largest_m);
  }
  if (!error.empty()) file.fail(error);
}

void load_meshes(const config::ConfigNode& list, std::vector<ConfiguredObject>& objects) {
  const std::vector<config::ConfigNode> nodes = list.items();
  for (int k = 0; k < std::ssize(objects); ++k)
    load_mesh_of(nodes[k], kLargestObject_m, objects[k]);
}

std::vector<ConfiguredObject> moveit_objects(const std::filesystem::path& file) {
  std::vector<ConfiguredObject> objects;
  for (const SceneObject& object : moveit::read_moveit_scene(file).objects) {
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
    return o.scale > 0 ? "" : fmt::format("scale: must be positive, not {}", o.scale);
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
  for (const double length : o.size) {
    if (!(length > 0)) return fmt::format("size: must be positive, not {}", length);
  }
  return "";
}

}  // namespace

config::Schema scene_schema(const config::KeyDescriptions& meanings) {
  return config::schema_of<SceneFile>(meanings);
}

std::string validation_error(const ConfiguredObject& o) {
  if (o.name.empty()) return "name: must not be empty";
  if (o.name == "table") return "name: 'table' is the table of scene.table";
  if (const double distance_m = o.position.norm(); distance_m > kMaxPosition_m) {
    return fmt::format("position: is {:.4g} m from the {}: positions are in m", distance_m,
                       name_of(o.relative_to));
  }
  return shape_error(o);
}

std::string validation_error(const TargetBody& o) {
  if (!o.grasp_point.empty() && o.grasp_point.size() != 2)
    return fmt::format("grasp_point: needs x and y, not {} numbers", o.grasp_point.size());
  return shape_error(o);
}

std::string validation_error(const TableOptions& o) {
  if (o.size.size() != 2) return fmt::format("size: needs x and y, not {} numbers", o.size.size());
  for (const double length : o.size) {
    if (!(length > 0)) return fmt::format("size: must be positive, not {}", length);
  }
  if (!(o.thickness > 0)) return fmt::format("thickness: must be positive, not {}", o.thickness);
  if (o.tip_clearance < 0) return "tip_clearance: must not be negative";
  if (o.resting_height_percentile < 0 || o.resting_height_percentile > 100) {
    return fmt::format("resting_height_percentile: must be in [0, 100], not {}",
                       o.resting_height_percentile);
  }
  if (o.side_margin < 0) return "side_margin: must not be negative";
  return "";
}

std::string validation_error(const TargetOptions& o) {
  if (o.name.empty() || o.name == "table") return "name: must not be empty or 'table'";
  const auto is_likely = [](double extent_m) {
    return extent_m >= kMinInferredExtent_m && extent_m <= kMaxInferredExtent_m;
  };
  const std::string bounds =
      fmt::format("an inferred target is {} to {} m wide and tall; give another shape with body",
                  kMinInferredExtent_m, kMaxInferredExtent_m);
  if (!is_likely(o.height)) return fmt::format("height: {}, not {} m tall", bounds, o.height);
  if (!is_likely(2 * o.min_radius))
    return fmt::format("min_radius: {}, not {} m wide", bounds, 2 * o.min_radius);
  if (o.max_radius < o.min_radius) return "max_radius: must not be below min_radius";
  if (!is_likely(2 * o.max_radius))
    return fmt::format("max_radius: {}, not {} m wide", bounds, 2 * o.max_radius);
  if (o.radius && !(*o.radius > 0))
    return fmt::format("radius: must be positive, not {}", *o.radius);
  if (o.radius && o.body) return "radius: not allowed together with body, which has its own size";
  if (o.pad_depth < 0) return "pad_depth: must not be negative";
  if (o.rim_margin < 0) return "rim_margin: must not be negative";
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
  if (radii.size() != 3 || std::ranges::any_of(radii, [](double r) { return !(r > 0); }))
    return "other_arm_radii: needs three positive radii: of upper arm, forearm and hand";
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
  const config::ConfigNode root = config::ConfigNode::load(node["file"].folder() / options.file);
  if (root.has("world")) {
    options.file_objects = moveit_objects(root.file());
    const bool own_table = options.table.infer || options.table.height;
    for (const ConfiguredObject& object : options.file_objects) {
      if (own_table && object.name == "table")
        root["world"].fail("contains a table: set scene.table.infer to false");
    }
  } else {
    SceneFile file;
    config::read_document(root, file);
    load_meshes(root["objects"], file.objects);
    options.file_objects = std::move(file.objects);
  }
  if (const std::string error = validation_error(options); !error.empty()) root.fail(error);
}

}  // namespace

void load_scene_files(SceneOptions& options, const config::ConfigNode& node) {
  if (node.has("objects")) load_meshes(node["objects"], options.objects);
  load_file(options, node);
  options.meshes.clear();
  if (options.target.body) {
    load_mesh_of(node["target"]["body"], kLargestTarget_m, *options.target.body);
    collision::add_to_cache(options.target.body->mesh, options.meshes);
  }
  for (const ConfiguredObject* object : configured_objects(options))
    collision::add_to_cache(object->mesh, options.meshes);
}

}  // namespace morphe::scene
