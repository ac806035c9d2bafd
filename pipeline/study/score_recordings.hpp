#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "pipeline/study/recordings_options.hpp"
#include "pipeline/study/study.hpp"

namespace morphe::study {

struct ScoreOptions : RecordingsStudyOptions {
  std::filesystem::path folder;  ///< of the config: paths start there
};

/// Import, movements and boundaries of marked recordings; a plot of each.
void score_real(const ScoreOptions& options, const RealSet& set, const StudyRun& run,
                StudyResult& result);

/// Movements, boundaries and positions of synthetic recordings against their truth; a line of the
/// boundary errors' distribution.
void score_synthetic(const ScoreOptions& options, const SyntheticSet& set, const StudyRun& run,
                     StudyResult& result, Plot& errors);

}  // namespace morphe::study
