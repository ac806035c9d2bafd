#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/config/node.hpp"
#include "core/config/schema.hpp"
#include "core/motion/geometry.hpp"
#include "pipeline/study/plot.hpp"

namespace morphe::study {

/// One figure of a study: what was measured, on what, and what is asked of it.
struct StudyRow {
  std::vector<std::pair<std::string, std::string>> of;  ///< the case: name and value, in order
  std::string metric, unit;                             ///< unit "1": a number without one
  double ours = kNotSeen;
  double published = kNotSeen;  ///< by others on the same case, NaN = nothing is
  double reachable = kNotSeen;  ///< share of the goals that the figure is about, NaN = all
  std::size_t n = 0;            ///< how many values it is made of
  double at_least = kNotSeen, at_most = kNotSeen;  ///< what is asked for, NaN = nothing
  bool timed = false;  ///< depends on the machine: printed, never written

  bool holds() const { return !(ours < at_least) && !(ours > at_most) && !(ours != ours); }
  bool asked() const { return at_least == at_least || at_most == at_most; }
};

using Case = std::vector<std::pair<std::string, std::string>>;
StudyRow row_of(const Case& of, const std::string& metric, const std::string& unit, double ours,
                std::size_t n);

struct StudyResult {
  std::string study;
  std::vector<StudyRow> rows;
  std::vector<std::pair<std::string, Plot>> plots;  ///< file name without .svg
};

struct StudyRun {
  std::filesystem::path config;
  std::filesystem::path
      folder;          ///< of the results, for what a study writes as it goes on; "": none
  bool quick = false;  ///< the small version that the tests run
  int jobs = 1;
  std::function<void(const std::string&)> progress;  ///< a line about what is done
};

/// Runs the study that the config's key `study` names. InputError for a bad config. The rows that
/// are not timed depend on config and inputs alone, not on the number of jobs.
StudyResult run_study(const StudyRun& run);

/// What the config of a study may hold, by what its key `study` says.
config::Schema study_schema(const config::Meanings& meanings);

/// Movements and boundaries, and what is rebuilt, against annotations and synthetic truth.
StudyResult recordings_study(const config::ConfigNode& config, const StudyRun& run);
/// The paper's table and figures again.
StudyResult paper_study(const config::ConfigNode& config, const StudyRun& run);
/// Whole movements through the pipeline, by variants of its config.
StudyResult mapping_study(const config::ConfigNode& config, const StudyRun& run);
/// Obstacles put into the way of movements: what repair makes of them.
StudyResult repair_study(const config::ConfigNode& config, const StudyRun& run);
/// The time law on random paths, beside the least time there is, and at the human's tempo.
StudyResult retime_study(const config::ConfigNode& config, const StudyRun& run);
/// Hands alone: tips, pinches and smoothness beside what peers publish.
StudyResult hands_study(const config::ConfigNode& config, const StudyRun& run);
/// Grasps with contacts as goals, held against where the person touched and against plain fingertip
/// goals. The plans go to plans/SET-HAND-VARIANT.h5 in the run's folder.
StudyResult grasp_study(const config::ConfigNode& config, const StudyRun& run);

}  // namespace morphe::study
