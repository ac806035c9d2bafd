#include <fmt/format.h>

#include <array>
#include <string_view>
#include <utility>

#include "core/moveit/read_messages.hpp"

namespace morphe::moveit {
namespace {

std::vector<double> components(const config::ConfigNode& node,
                               const std::vector<const char*>& names) {
  std::vector<double> values;
  if (node.is_map())
    for (const char* name : names) values.push_back(node[name].number(bounds::kCoordinate));
  else
    values = node.numbers(bounds::kCoordinate);
  if (values.size() != names.size())
    node.fail(fmt::format("must have {} numbers, not {}", names.size(), values.size()));
  return values;
}

Pose pose_of_keys(const config::ConfigNode& node, const char* position, const char* rotation) {
  return make_pose(node.has(position) ? read_vector(node[position]) : Vec3(Vec3::Zero()),
                   node.has(rotation) ? read_rotation(node[rotation]) : Quat::Identity());
}

SceneObject still_object(Shape shape, std::vector<double> size, const Pose& pose) {
  SceneObject object;
  object.shape = shape;
  object.size = std::move(size);
  object.time = {0};
  object.position = {pose.translation()};
  object.orientation = {Quat(pose.linear()).normalized()};
  return object;
}

/// A type of shape_msgs/SolidPrimitive, given by number or name, with its number of dimensions.
struct Primitive {
  Shape shape;
  std::string_view name;
  std::size_t dimensions;
};

Primitive primitive_of(const config::ConfigNode& node) {
  static constexpr std::array<Primitive, 3> kPrimitives{
      {{Shape::box, "box", 3}, {Shape::sphere, "sphere", 1}, {Shape::cylinder, "cylinder", 2}}};
  const std::string type = node.text();
  for (int k = 0; k < std::ssize(kPrimitives); ++k)
    if (type == kPrimitives[k].name || type == std::to_string(k + 1)) return kPrimitives[k];
  node.fail(fmt::format("must be box, sphere or cylinder, not '{}'", type));
}

SceneObject read_mesh(const config::ConfigNode& node, const Pose& base_from_mesh) {
  SceneObject object = still_object(Shape::mesh, {}, base_from_mesh);
  for (const config::ConfigNode& vertex : node["vertices"].items())
    object.vertices.push_back(read_vector(vertex));
  for (const config::ConfigNode& item : node["triangles"].items()) {
    const auto corners = (item.is_map() ? item["vertex_indices"] : item).items();
    if (corners.size() != 3) item.fail("must have 3 corners");
    Eigen::Vector3i triangle;
    for (int k = 0; k < 3; ++k) {
      const std::int64_t corner = corners[k].integer();
      if (corner < 0 || corner >= std::ssize(object.vertices))
        item.fail(fmt::format("there is no vertex {}", corner));
      triangle[k] = static_cast<int>(corner);
    }
    object.triangles.push_back(triangle);
  }
  if (object.triangles.empty()) node["triangles"].fail("must not be empty");
  return object;
}

}  // namespace

Vec3 read_vector(const config::ConfigNode& node) {
  const std::vector<double> v = components(node, {"x", "y", "z"});
  return {v[0], v[1], v[2]};
}

Quat read_rotation(const config::ConfigNode& node) {
  const std::vector<double> v = components(node, {"x", "y", "z", "w"});
  const Quat rotation(v[3], v[0], v[1], v[2]);
  const double length = rotation.norm();
  if (length == 0) return Quat::Identity();
  if (std::abs(length - 1) > 1e-3) node.fail(fmt::format("has length {}, not 1", length));
  return rotation.normalized();
}

Pose read_pose(const config::ConfigNode& node) {
  return pose_of_keys(node, "position", "orientation");
}

Pose read_transform(const config::ConfigNode& node) {
  return pose_of_keys(node, "translation", "rotation");
}

std::vector<config::ConfigNode> items_of(const config::ConfigNode& node, const char* key) {
  return node.has(key) ? node[key].items() : std::vector<config::ConfigNode>{};
}

void refuse(const config::ConfigNode& node, const char* key, const char* why) {
  if (!node.has(key)) return;
  const config::ConfigNode value = node[key];
  const bool has_content = value.is_map()    ? !value.keys().empty()
                           : value.is_list() ? !value.items().empty()
                                             : !value.text().empty();
  if (has_content) value.fail(why);
}

SceneObject read_primitive(const config::ConfigNode& node, const Pose& base_from_shape) {
  const Primitive primitive = primitive_of(node["type"]);
  std::vector<double> size = node["dimensions"].numbers(bounds::kObjectSize);
  if (size.size() != primitive.dimensions)
    node["dimensions"].fail(
        fmt::format("must have {} numbers, not {}", primitive.dimensions, size.size()));
  if (primitive.shape == Shape::cylinder) std::swap(size[0], size[1]);  // height, radius in MoveIt
  return still_object(primitive.shape, size, base_from_shape);
}

std::vector<SceneObject> read_shapes(const config::ConfigNode& owner, const Pose& base_from_owner) {
  std::vector<SceneObject> shapes;
  const auto read = [&](const char* key, const char* pose_key, auto shape_of) {
    const auto items = items_of(owner, key), poses = items_of(owner, pose_key);
    // MoveIt places a single shape without a pose at its owner's pose.
    if (poses.size() != items.size() && !(items.size() == 1 && poses.empty()))
      owner.fail(fmt::format("{} {} but {} {}; must be as many", items.size(), key, poses.size(),
                             pose_key));
    for (int k = 0; k < std::ssize(items); ++k) {
      const Pose owner_from_shape = poses.empty() ? Pose(Pose::Identity()) : read_pose(poses[k]);
      shapes.push_back(shape_of(items[k], base_from_owner * owner_from_shape));
    }
  };
  read("primitives", "primitive_poses", read_primitive);
  read("meshes", "mesh_poses", read_mesh);
  if (shapes.empty()) owner.fail("has neither primitives nor meshes");
  return shapes;
}

}  // namespace morphe::moveit
