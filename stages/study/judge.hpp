#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/motion/demonstration.hpp"
#include "stages/study/recordings_options.hpp"
#include "stages/study/study.hpp"

namespace morphe {

struct JudgeOptions : RecordingsStudyOptions {
  std::filesystem::path folder;  ///< of the config: paths start there
};

/// Import, movements and boundaries of marked recordings; a plot of each.
void judge_real(const JudgeOptions& options, const RealSet& set, const StudyRun& run,
                StudyResult& result);

/// Movements, boundaries and positions of synthetic recordings against their truth; a line of the
/// boundary errors' distribution.
void judge_synthetic(const JudgeOptions& options, const SyntheticSet& set, const StudyRun& run,
                     StudyResult& result, Plot& errors);

using Case = std::vector<std::pair<std::string, std::string>>;
StudyRow row_of(const Case& of, const std::string& metric, const std::string& unit, double ours,
                std::size_t n);

/// The value below which a share of the values lies (nearest rank), NaN if there is none.
double quantile(std::vector<double> values, double share);

/// Over the values that are numbers, NaN if there is none.
double mean(const std::vector<double>& values);

/// Seconds that something took.
template <class Work>
double seconds(const Work& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace morphe
