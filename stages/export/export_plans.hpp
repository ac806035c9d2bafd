#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "stages/export/export_index.hpp"
#include "stages/export/plan_motions.hpp"

namespace morphe::exports {

/// csv, ros, ros-json, robomimic.
std::vector<std::string> export_format_names();

struct ExportOptions {
  std::string format;
  std::vector<std::string> groups = {"all"};  ///< as joint_group() takes them: a file each
  MotionOptions motion;
  bool replace = false;  ///< files that are there with other content
};

struct ExportReport {
  std::vector<std::string> files;  ///< written, names inside the folder; the index is the last
  std::vector<LeftOut> left_out;   ///< every other plan
  std::string remark;              ///< what to know of the files, or ""
};

/// Writes what a plans.h5 holds of plans with a trajectory for others to read:
/// - csv: <demonstration>_<000>.csv and, with an approach and a retreat apart, …_approach.csv and
///   …_retreat.csv; of a group other than all: …_arm.csv, …_approach_arm.csv
/// - ros, ros-json: the same with .yaml or .json, a JointTrajectory each
/// - of a plan that names contacts, beside its trajectory: csv …_contacts.csv and …_squeeze.csv,
///   ros and ros-json …_grasp.json, robomimic /grasps/demo_N
/// - robomimic: robomimic.hdf5, all plans in one, without approach and retreat, which are no
///   demonstration; no file if no plan has a trajectory
/// and index_<format>.json, which lists them.
///
/// The folder must exist. The files appear together, each whole; nothing else in the folder is
/// touched. InputError if the plans cannot be read, the folder not be written, a file with other
/// content is in the way and may not be replaced, or the options do not fit format or plans.
ExportReport export_plans(const std::filesystem::path& plans, const std::filesystem::path& folder,
                          const ExportOptions& asked);

}  // namespace morphe::exports
