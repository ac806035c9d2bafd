#pragma once

#include <vector>

#include "core/motion/demonstration.hpp"
#include "pipeline/planning/pipeline_config.hpp"

namespace morphe::study {

/// The plans of recordings, in their order, and the processor time of the mapping.
struct PlannedRecordings {
  std::vector<Plan> plans;
  double map_s = 0;
};
/// Plans all movements of the recordings on `jobs` threads.
PlannedRecordings plan_recordings(const planning::LoadedConfig& config,
                                  const std::vector<Demonstration>& recordings, int jobs);

}  // namespace morphe::study
