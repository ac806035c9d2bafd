#pragma once

#include <filesystem>

#include "core/motion/demonstration.hpp"
#include "pipeline/study/recordings_options.hpp"
#include "pipeline/study/study.hpp"

namespace morphe::study {

/// The options of the study with the folder of its config.
struct ScoreOptions : RecordingsStudyOptions {
  std::filesystem::path folder;  ///< folder of the config, to which paths are relative
};

/// Evaluates import, movements and boundaries of annotated recordings, and makes a plot of each.
void score_real(const ScoreOptions& options, const RealSet& set, const StudyRun& run,
                StudyResult& result);

/// Evaluates movements, boundaries and positions of synthetic recordings against their ground
/// truth, and adds a line with the distribution of the boundary errors.
void score_synthetic(const ScoreOptions& options, const SyntheticSet& set, const StudyRun& run,
                     StudyResult& result, Plot& errors);

}  // namespace morphe::study
