#include "pipeline/planning/run_config.hpp"

#include <fmt/format.h>

#include "core/config/fields.hpp"
#include "core/files/sha256.hpp"
#include "core/store/bytes.hpp"
#include "core/store/plan_file.hpp"
#include "pipeline/planning/unpacked_inputs.hpp"

namespace morphe::planning {
namespace {

namespace fs = std::filesystem;

std::string without_paths(PipelineConfig options) {
  options.dataset.reset();
  options.robot.file.clear();
  options.scene.file.clear();
  return config::write_options(options);
}

std::string scene_sha256(const scene::SceneOptions& scene) {
  std::string bytes;
  for (const auto* objects : {&scene.objects, &scene.file_objects}) {
    for (const scene::ConfiguredObject& object : *objects)
      bytes += config::write_options(object) + store::bytes_of(object.mesh);
  }
  if (scene.target.body) bytes += store::bytes_of(scene.target.body->mesh);
  return files::sha256(bytes);
}

}  // namespace

RunConfig run_config(LoadedConfig loaded) {
  RunConfig config;
  config.effective = loaded.effective;
  config.without_paths = without_paths(loaded.options);
  config.scene_sha256 = scene_sha256(loaded.options.scene);
  config.loaded = std::move(loaded);
  return config;
}

RunConfig stored_config(const fs::path& plans) {
  const store::PlanReader reader(plans);
  const PlanFileHeader& header = reader.header();
  LoadedConfig loaded;
  config::ConfigNode node = config::ConfigNode::parse(header.config, plans.string() + ":/@config");
  config::read_document(node, loaded.options);
  loaded.robot = robot::Robot(reader.robot());
  loaded.inputs = header.inputs;
  loaded.assumptions = header.assumptions;
  loaded.effective = header.config;
  if (config::write_options(loaded.options) != header.config)
    throw InputError(fmt::format("{}: /@config: was written by another version ({})",
                                 plans.string(), header.software));
  if (node.has("scene")) {
    const UnpackedInputs files(header.inputs);
    const std::string named = loaded.options.scene.file;
    if (!named.empty()) {
      const fs::path file = files.find(named);
      if (file.empty())
        throw InputError(fmt::format("{}: /inputs: does not contain {}", plans.string(), named));
      loaded.options.scene.file = file.string();
    }
    try {
      scene::load_scene_files(loaded.options.scene, node["scene"]);
    } catch (const InputError& error) {
      throw InputError(
          fmt::format("{}: does not contain the mesh files; run with the config file instead: {}",
                      plans.string(), files.with_stored_paths(error.what())));
    }
    loaded.options.scene.file = named;
  }
  RunConfig config = run_config(std::move(loaded));
  config.dataset_sha256 = header.dataset_sha256;
  return config;
}

}  // namespace morphe::planning
