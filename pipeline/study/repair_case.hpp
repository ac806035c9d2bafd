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
  /// True if the plan is executable.
  bool executable = false;
  /// Metric A of the path divided by that of the mapping.
  double humanlikeness_ratio = kUnknown;
  /// Mean error of the tips over the path [m].
  double mean_tip_error_m = kUnknown;
  /// True if a sample marked as mapped differs from the mapping.
  bool mapped_samples_changed = false;
  /// Number of states of the trajectory that FCL finds in collision.
  std::size_t colliding_states = 0;
  /// The number of states that were checked.
  std::size_t states = 0;
  /// Reason and detail of the failure.
  std::string failure;
};

/// A movement with an obstacle and the results of all methods.
struct ObstacleCase {
  /// True if the plan is executable without an obstacle and an obstacle was found.
  bool is_valid = false;
  /// The index of the synthetic recording.
  std::uint64_t recording = 0;
  /// The kind of the obstacle.
  std::string kind;
  /// The results of the variants.
  std::vector<RepairOutcome> variants;
  /// True if a long search makes an executable plan.
  bool found_by_long_search = false;
};

/// A study with the files that it refers to.
struct RepairStudy {
  /// The options of the study.
  const RepairStudyOptions& options;
  /// The path of the pipeline config.
  std::filesystem::path pipeline;
  /// The options of the synthetic recordings.
  synthesize::SynthesizeOptions synthetic;
};

/// Plans the movement of one synthetic recording without and then with an obstacle in its way, by
/// each variant and by a planner alone (`plain`). The long searches are run only if the first
/// variant fails.
ObstacleCase run_case(const RepairStudy& study, const std::vector<planning::LoadedConfig>& variants,
                      const planning::LoadedConfig& plain,
                      const std::vector<planning::LoadedConfig>& long_searches,
                      std::uint64_t index);

}  // namespace morphe::study
