#pragma once

#include <filesystem>
#include <string>

#include "pipeline/planning/pipeline_config.hpp"

namespace morphe::planning {

/// A config with the values that identify it.
struct RunConfig {
  LoadedConfig loaded;
  std::string effective;       ///< in the form stored in plans.h5
  std::string without_paths;   ///< the part that plans depend on: `effective` without file names
  std::string scene_sha256;    ///< of the objects in the scene's file and meshes
  std::string dataset_sha256;  ///< required for the dataset; "" if any is accepted
};

/// Returns the run config of a loaded config.
RunConfig run_config(LoadedConfig loaded);

/// Returns the config, robot and scene of a plans.h5 from the file alone, and the dataset that it
/// requires. Throws InputError if it is not a plans.h5, or its scene names files that it does not
/// contain (meshes).
RunConfig stored_config(const std::filesystem::path& plans);

}  // namespace morphe::planning
