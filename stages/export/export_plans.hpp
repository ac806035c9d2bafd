#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "stages/export/export_index.hpp"
#include "stages/export/plan_motions.hpp"
#include "stages/export/table/split.hpp"

namespace morphe::exports {

/// Returns the names of the formats: csv, ros, ros-json, robomimic, table, lerobot.
std::vector<std::string> export_format_names();

/// The options of an export.
struct ExportOptions {
  std::string format;                         ///< one of export_format_names()
  std::vector<std::string> groups = {"all"};  ///< as for joint_group(), one file each
  MotionOptions motion;
  std::string where;  ///< condition on the plans (Condition), "" for all
  SplitOptions split;
  std::string
      not_verified;      ///< "" for plans that `verify` accepts, else what the files say of them
  bool replace = false;  ///< true if existing files with other content may be replaced
};

/// The result of an export.
struct ExportReport {
  std::vector<std::string> files;    ///< names inside the folder; the index is the last
  std::vector<SkippedPlan> skipped;  ///< the plans that were not exported
  std::vector<std::string> notes;    ///< phrases on the condition and the rate
  std::string limit_use;             ///< sentence on the use of limits between the points, or ""
  std::string remark;                ///< on limits that are exceeded between the points, or ""
};

/// Exports the plans of a plans.h5 that have a trajectory to files in `folder`:
/// - csv: <demonstration>_<000>.csv and, with a separate approach and retreat, …_approach.csv and
///   …_retreat.csv; for a group other than all: …_arm.csv, …_approach_arm.csv
/// - ros, ros-json: the same with .yaml or .json, each file a JointTrajectory
/// - robomimic: robomimic.hdf5 with all plans, without approach and retreat, which are not part of
///   the demonstration, by default at 20 frames per second; no file if no plan has a trajectory
/// - table: plans.csv, plans.parquet and README.md, with all plans, also infeasible ones
/// - lerobot: a LeRobotDataset v3.0 (lerobot/dataset_writer.hpp), by default at 30 frames per
///   second, with plans.parquet and README.md
/// - for a plan with contacts, in addition: with csv …_contacts.csv and …_grasp_force.csv, with ros
///   and ros-json …_grasp.json, with robomimic /grasps/demo_N in its file
/// - index_<format>.json, which lists the files; not for table and lerobot.
///
/// The folder must exist. The files appear together, each complete; other files in the folder are
/// not touched. Throws InputError if the plans cannot be read, the folder cannot be written, a file
/// with other content exists and may not be replaced, or the options do not suit the format or the
/// plans, or if no plan is left. The format is one of export_format_names().
ExportReport export_plans(const std::filesystem::path& plans, const std::filesystem::path& folder,
                          const ExportOptions& requested);

}  // namespace morphe::exports
