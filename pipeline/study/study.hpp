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

/// The condition under which a figure was measured, as pairs of name and value in order.
using Case = std::vector<std::pair<std::string, std::string>>;
/// Returns a condition with one more pair.
Case case_with(Case condition, const std::string& name, const std::string& value);

/// One figure of a study: the measured quantity, its case, and the requirement.
struct StudyRow {
  Case case_values;
  std::string metric, unit;     ///< unit "1" denotes a dimensionless number
  double ours = kUnknown;       ///< the measured value
  double published = kUnknown;  ///< value of others for the same case, NaN if there is none
  double reachable = kUnknown;  ///< share of the case's goals that are reachable, NaN if unknown
  std::ptrdiff_t count = 0;     ///< number of values from which the figure is computed
  double at_least = kUnknown, at_most = kUnknown;  ///< required limits, NaN (x != x) if not
  bool is_timing = false;  ///< depends on the machine: the row is printed but never written

  /// Returns true if the value is within the required limits and not NaN.
  bool meets_requirement() const {
    return !(ours < at_least) && !(ours > at_most) && !(ours != ours);
  }
  /// Returns true if there is a requirement.
  bool has_requirement() const { return at_least == at_least || at_most == at_most; }
};

/// The results of a study.
struct StudyResult {
  std::string study;
  std::vector<StudyRow> rows;
  std::vector<std::pair<std::string, Plot>> plots;  ///< plots with their file names without .svg
  std::vector<std::pair<std::string, PlotGrid>> grids;      ///< likewise
  std::vector<std::pair<std::string, std::string>> tables;  ///< Markdown, with names without .md

  /// Adds a row without a requirement and returns it, valid until another row is added.
  StudyRow& add(const Case& condition, const std::string& metric, const std::string& unit,
                double ours, std::ptrdiff_t n);
};

/// The inputs of a run of a study.
struct StudyRun {
  std::filesystem::path config;
  std::filesystem::path folder;  ///< for files that a study writes while it runs, or ""
  bool quick = false;            ///< the small version that the tests run
  int jobs = 1;                  ///< number of threads
  std::function<void(const std::string&)> progress;  ///< prints a line, never empty
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
/// Evaluates retiming on random paths, against the minimum time and at the human's tempo.
StudyResult retime_study(const config::ConfigNode& config, const StudyRun& run);
/// Evaluates hands without an arm: tips, pinches and smoothness, ours and of published methods.
StudyResult hands_study(const config::ConfigNode& config, const StudyRun& run);
/// Evaluates grasps with contacts as goals against the contacts of the person and against plain
/// fingertip goals. The plans are written to plans/SET-HAND-VARIANT.h5 in the run's folder.
StudyResult grasp_study(const config::ConfigNode& config, const StudyRun& run);
/// Plans recordings with several values of weights, and names the value beyond which posture, tempo
/// and the number of executable movements lose more than they gain.
StudyResult trade_off_study(const config::ConfigNode& config, const StudyRun& run);

}  // namespace morphe::study
