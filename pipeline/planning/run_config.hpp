#pragma once

#include <filesystem>
#include <string>

#include "pipeline/planning/pipeline_config.hpp"

namespace morphe::planning {

/// A config with the values that identify it.
struct RunConfig {
  LoadedConfig loaded;
  std::string effective;       ///< in the form stored in plans.h5
  std::string without_paths;   ///< `effective` without file names, on which plans do not depend
  std::string scene_sha256;    ///< of the objects of config and scene file, with their meshes
  std::string dataset_sha256;  ///< hash that the dataset must have; "" if any is accepted
};

/// Returns the run config of a loaded config, which accepts any dataset.
RunConfig run_config(LoadedConfig loaded);

/// Returns the config, robot and scene of a plans.h5 from the file alone, and the hash of the
/// dataset that it requires. Throws InputError if it is not a plans.h5, lacks inputs, was changed,
/// or was written by another version.
RunConfig stored_config(const std::filesystem::path& plans);

}  // namespace morphe::planning
