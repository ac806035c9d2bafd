#pragma once

#include <string>
#include <vector>

#include "core/store/plan_file.hpp"
#include "stages/export/export_index.hpp"
#include "stages/export/export_plans.hpp"
#include "stages/export/limit_use.hpp"
#include "stages/export/plan_selection.hpp"
#include "stages/export/staged_files.hpp"

namespace morphe::exports {

/// An export that is under way.
struct ExportRun {
  const store::PlanReader& reader;
  ExportOptions options;
  PlanSelection selection;
  StagedFiles files;
  ExportIndex index;
  WorstLimitUse limits;
  bool has_approach_or_retreat = false;  ///< true if a plan has an approach or a retreat
};

/// Enters the plan's motions into the index, without files, and returns them; empty if the plan is
/// skipped.
std::vector<PlanMotion> add_to_index(ExportRun& run, const ChosenPlan& chosen, const Plan& plan);

/// Returns the time at which the plan's trajectory begins in the exported motion "trajectory".
double time_before_s(const Plan& plan, const MotionOptions& options);
/// Returns the time of the grasp in it; the plan has a grasp.
double grasp_time_s(const Plan& plan, const MotionOptions& options);

/// Returns the card of the exported dataset.
std::string card_of(const ExportRun& run, const std::string& kind, const std::string& front_matter,
                    const std::string& content);

/// Returns the rate of the planned samples, which are equidistant, rounded to 1e-6 Hz.
double sample_rate_hz(const Trajectory& trajectory);

/// Returns the names of the formats of export_texts().
std::vector<std::string> text_format_names();

// Each function writes the files of one format, or of one kind of formats.

/// Writes one text per motion and joint group.
void export_texts(ExportRun& run);
/// Writes robomimic.hdf5.
void export_robomimic(ExportRun& run);
/// Writes the table of quality: plans.csv, plans.parquet and README.md.
void export_table(ExportRun& run);
/// Writes a LeRobotDataset v3.0.
void export_lerobot(ExportRun& run);

}  // namespace morphe::exports
