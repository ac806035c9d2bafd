#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/planning/pipeline_config.hpp"
#include "pipeline/study/repair_options.hpp"
#include "pipeline/synthesize/synthesize.hpp"

namespace morphe::study {

/// The result of one repair method on a case.
struct RepairOutcome {
  bool executable = false;
  double humanlikeness_ratio = kUnknown;  ///< A of the path divided by A of the mapped path
  double mean_tip_error_m = kUnknown;     ///< over the path
  bool mapped_samples_changed = false;    ///< a sample marked as mapped differs from the mapping
  int colliding_states = 0;               ///< states of the trajectory that FCL finds in collision
  std::string failure;                    ///< reason and detail, if it is not executable
};

/// A movement with an obstacle and the results of all methods.
struct ObstacleCase {
  bool is_valid = false;        ///< executable without an obstacle, and an obstacle was found
  std::uint64_t recording = 0;  ///< index of the synthetic recording
  std::string kind;             ///< kind of the obstacle
  std::vector<RepairOutcome> variants;  ///< one for each variant, the last for the planner alone
  bool found_by_long_search = false;    ///< true if a long search makes an executable plan
};

/// The options of a study, the path of its pipeline config, and the content of `options.synthetic`.
struct RepairStudy {
  const RepairStudyOptions& options;
  std::filesystem::path pipeline;
  synthesize::SynthesizeOptions synthetic;
};

/// Plans the movement of one synthetic recording without and then with an obstacle in its way, by
/// each variant and by a planner alone. The long searches run only if the first variant fails.
ObstacleCase run_case(const RepairStudy& study, const std::vector<planning::LoadedConfig>& variants,
                      const planning::LoadedConfig& planner_only,
                      const std::vector<planning::LoadedConfig>& long_searches,
                      std::uint64_t index);

}  // namespace morphe::study
