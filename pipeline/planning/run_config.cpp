#include "pipeline/planning/run_config.hpp"

#include <fmt/format.h>

#include "core/config/fields.hpp"
#include "core/files/sha256.hpp"
#include "core/store/bytes.hpp"
#include "core/store/plan_file.hpp"

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
  try {
    loaded = reload_config(header);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", plans.string(), error.what()));
  }
  if (loaded.effective != header.config)
    throw InputError(fmt::format(
        "{}: /@config: does not follow from /inputs and /@settings; it was changed, or written by "
        "another version ({})",
        plans.string(), header.software));
  loaded.robot = robot::Robot(reader.robot());
  loaded.assumptions = header.assumptions;
  RunConfig config = run_config(std::move(loaded));
  config.dataset_sha256 = header.dataset_sha256;
  return config;
}

}  // namespace morphe::planning
