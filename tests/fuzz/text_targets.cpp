#include "core/collision/mesh_file.hpp"
#include "core/collision/stl_file.hpp"
#include "core/config/node.hpp"
#include "core/motion/input_error.hpp"
#include "core/moveit/planning_scene.hpp"
#include "core/robot/files/description.hpp"
#include "core/robot/files/mjcf_urdf.hpp"
#include "core/robot/files/urdf_model.hpp"
#include "stages/import/folders/manifest.hpp"
#include "targets.hpp"

namespace morphe::fuzz {
namespace {

/// Everything that a document holds, in whatever form it has.
void read_all(const config::ConfigNode& node) {
  if (node.is_map()) {
    for (const std::string& key : node.keys())
      if (node.has(key)) read_all(node[key]);
  } else if (node.is_list()) {
    for (const config::ConfigNode& item : node.items()) read_all(item);
  } else if (node.is_scalar()) {
    try {
      node.number();
    } catch (const InputError&) {
    }
  }
}

void read_yaml(std::string_view bytes) {
  const config::ConfigNode node = config::ConfigNode::parse(std::string(bytes), "a.yaml");
  config::ConfigNode copy = node.copy_as_document();
  copy.extend(node);
  read_all(copy);
  copy.require_all_keys_read();
}

void read_set(std::string_view bytes) {
  config::ConfigNode node = config::ConfigNode::parse("map: {starts: 1}\n", "a.yaml");
  const std::size_t equals = bytes.find('=');
  if (equals == std::string_view::npos) return;
  node.set(std::string(bytes.substr(0, equals)), std::string(bytes.substr(equals + 1)));
  read_all(node);
}

Target mesh(const std::string& ending) {
  return {"mesh-" + ending,
          [ending](std::string_view bytes) {
            SceneObject mesh;
            collision::load_mesh(as_file(bytes, "a." + ending), 1, false, mesh);
          },
          true};
}

}  // namespace

std::vector<Target> text_targets() {
  return {
      {"yaml", read_yaml},
      {"set", read_set},
      {"robot", [](std::string_view bytes) { robot::load_robot(as_file(bytes, "a.yaml")); }},
      {"urdf", [](std::string_view bytes) { robot::load_urdf_model(as_file(bytes, "a.urdf")); }},
      {"mjcf",
       [](std::string_view bytes) {
         robot::urdf_of(robot::read_mjcf(as_file(bytes, "a.xml")), "folder");
       }},
      {"moveit",
       [](std::string_view bytes) { moveit::read_moveit_scene(as_file(bytes, "scene.yaml")); }},
      {"manifest",
       [](std::string_view bytes) { imports::read_manifest(as_file(bytes, "recordings.yaml")); }},
      {"stl",
       [](std::string_view bytes) {
         SceneObject mesh;
         collision::read_stl(as_file(bytes, "a.stl"), mesh);
       }},
      mesh("obj"),
      mesh("dae"),
      mesh("gltf"),
  };
}

}  // namespace morphe::fuzz
