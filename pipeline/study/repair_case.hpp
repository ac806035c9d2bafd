#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/planning/pipeline_config.hpp"
#include "pipeline/study/repair_options.hpp"
#include "pipeline/synthesize/synthesize.hpp"

namespace morphe::study {

/// What one way of repairing made of a case.
struct Repaired {
  bool executable = false;
  double a_ratio = kNotSeen;     ///< metric A of the path over that of the mapping
  double tips_m = kNotSeen;      ///< mean over the path
  bool outside_changed = false;  ///< a sample that is called mapped is not what was mapped
  std::size_t collisions = 0;    ///< states of the trajectory that FCL finds in collision
  std::size_t states = 0;
  std::string failure;  ///< reason and detail
};

struct ObstacleCase {
  bool exists = false;  ///< executable without an obstacle, and one can be put into the way
  std::uint64_t recording = 0;
  std::string kind;
  std::vector<Repaired> variants;
  bool found_by_long_search = false;
};

/// A study with the files that it names.
struct RepairStudy {
  const RepairStudyOptions& options;
  std::filesystem::path pipeline;
  synthesize::SynthesizeOptions synthetic;
};

/// The movement of one synthetic recording, planned free and then with an obstacle in its way, by
/// each variant and by a planner alone (`plain`). The long searches are for what the first variant
/// fails at.
ObstacleCase run_case(const RepairStudy& study, const std::vector<planning::LoadedConfig>& variants,
                      const planning::LoadedConfig& plain,
                      const std::vector<planning::LoadedConfig>& long_searches,
                      std::uint64_t index);

}  // namespace morphe::study
