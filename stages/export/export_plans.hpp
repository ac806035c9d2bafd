#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "stages/export/export_index.hpp"
#include "stages/export/plan_motions.hpp"

namespace morphe::exports {

/// Returns the names of the formats: csv, ros, ros-json, robomimic.
std::vector<std::string> export_format_names();

/// The options of an export.
struct ExportOptions {
  std::string format;
  /// groups as accepted by joint_group(), one file each
  std::vector<std::string> groups = {"all"};
  MotionOptions motion;
  bool replace = false;  ///< true if existing files with other content may be replaced
};

/// The result of an export.
struct ExportReport {
  /// written files, as names inside the folder; the index is the last
  std::vector<std::string> files;
  std::vector<SkippedPlan> skipped;  ///< all other plans
  std::string remark;                ///< a remark on the files, or ""
};

/// Exports the plans of a plans.h5 that have a trajectory:
/// - csv: <demonstration>_<000>.csv and, with a separate approach and retreat, …_approach.csv and
///   …_retreat.csv; for a group other than all: …_arm.csv, …_approach_arm.csv
/// - ros, ros-json: the same with .yaml or .json, each file a JointTrajectory
/// - for a plan with contacts, in addition to its trajectory: csv …_contacts.csv and …_squeeze.csv,
///   ros and ros-json …_grasp.json, robomimic /grasps/demo_N
/// - robomimic: robomimic.hdf5 with all plans, without approach and retreat, which are not part of
///   the demonstration; no file if no plan has a trajectory
/// and index_<format>.json, which lists them.
///
/// The folder must exist. The files appear together, each complete; other files in the folder are
/// not touched. Throws InputError if the plans cannot be read, the folder cannot be written, a file
/// with other content exists and may not be replaced, or the options do not fit the format or the
/// plans.
ExportReport export_plans(const std::filesystem::path& plans, const std::filesystem::path& folder,
                          const ExportOptions& asked);

}  // namespace morphe::exports
