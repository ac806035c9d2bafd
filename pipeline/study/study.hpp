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

/// One figure of a study: the measured quantity, its case, and the requirement.
struct StudyRow {
  /// The case as pairs of name and value, in order.
  std::vector<std::pair<std::string, std::string>> case_values;
  /// Unit "1" denotes a dimensionless number.
  std::string metric, unit;
  /// The measured value.
  double ours = kUnknown;
  /// Value published by others for the same case, NaN if there is none.
  double published = kUnknown;
  /// Share of the goals to which the figure refers, NaN for all.
  double reachable = kUnknown;
  /// Number of values from which the figure is computed.
  std::size_t count = 0;
  /// Required limits, NaN for no requirement.
  double at_least = kUnknown, at_most = kUnknown;
  /// True if the value depends on the machine; such rows are printed but never written.
  bool is_timing = false;

  /// Returns true if the value is within the required limits and not NaN.
  bool meets_requirement() const {
    return !(ours < at_least) && !(ours > at_most) && !(ours != ours);
  }
  /// Returns true if there is a requirement.
  bool has_requirement() const { return at_least == at_least || at_most == at_most; }
};

/// A case as pairs of name and value.
using Case = std::vector<std::pair<std::string, std::string>>;
/// Makes a row without a requirement.
StudyRow make_row(const Case& of, const std::string& metric, const std::string& unit, double ours,
                  std::size_t n);

/// The results of a study.
struct StudyResult {
  /// The name of the study.
  std::string study;
  /// The rows, in the order of the tables.
  std::vector<StudyRow> rows;
  /// Plots with their file names without .svg.
  std::vector<std::pair<std::string, Plot>> plots;
};

/// The inputs of a run of a study.
struct StudyRun {
  /// The path of the config.
  std::filesystem::path config;
  /// Folder of the results, for files that a study writes while it runs; "" to write no files.
  std::filesystem::path folder;
  /// True for the small version that the tests run.
  bool quick = false;
  /// The number of threads.
  int jobs = 1;
  /// Called with a line about the progress.
  std::function<void(const std::string&)> progress;
};

/// Runs the study that the config's key `study` names. Throws InputError for an invalid config.
/// Rows that are not timed depend only on config and inputs, not on the number of jobs.
StudyResult run_study(const StudyRun& run);

/// Returns the schema of a study's config, which depends on the value of its key `study`.
config::Schema study_schema(const config::KeyDescriptions& meanings);

/// Evaluates movements, boundaries and reconstruction against annotations and synthetic ground
/// truth.
StudyResult recordings_study(const config::ConfigNode& config, const StudyRun& run);
/// Reproduces the table and the figures of the paper.
StudyResult paper_study(const config::ConfigNode& config, const StudyRun& run);
/// Runs whole movements through the pipeline by variants of its config.
StudyResult mapping_study(const config::ConfigNode& config, const StudyRun& run);
/// Evaluates repair with obstacles in the way of movements.
StudyResult repair_study(const config::ConfigNode& config, const StudyRun& run);
/// Evaluates time parametrisation on random paths, in comparison with the minimum time and at the
/// human's tempo.
StudyResult retime_study(const config::ConfigNode& config, const StudyRun& run);
/// Evaluates hands alone: tips, pinches and smoothness in comparison with published methods.
StudyResult hands_study(const config::ConfigNode& config, const StudyRun& run);
/// Evaluates grasps with contacts as goals, in comparison with the contacts of the person and with
/// plain fingertip goals. The plans are written to plans/SET-HAND-VARIANT.h5 in the run's folder.
StudyResult grasp_study(const config::ConfigNode& config, const StudyRun& run);

}  // namespace morphe::study
