#pragma once

#include <filesystem>
#include <string>

#include "pipeline/planning/pipeline_config.hpp"

namespace morphe::planning {

/// A config with what tells it from others.
struct RunConfig {
  LoadedConfig loaded;
  std::string effective;       ///< as plans.h5 holds it
  std::string without_paths;   ///< what plans depend on: effective, but for the names of files
  std::string scene_sha256;    ///< of the objects that a scene's file and meshes hold
  std::string dataset_sha256;  ///< that the dataset must have, "" = any
};

RunConfig run_config(LoadedConfig loaded);

/// The config, robot and scene that a plans.h5 was made with, from the file alone, and the dataset
/// that it asks for. InputError: no plans.h5, or one whose scene names files that it does not hold
/// (meshes).
RunConfig stored_config(const std::filesystem::path& plans);

}  // namespace morphe::planning
