#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace morphe::exports {

/// csv, ros, robomimic.
std::vector<std::string> export_format_names();

struct ExportReport {
  std::vector<std::string> files;  ///< written, names inside the folder
  struct Left {
    std::string plan, why;
  };
  std::vector<Left> left_out;  ///< every other plan
};

/// Writes what a plans.h5 holds of executable plans for others to read:
/// - csv: <demonstration>_<000>.csv and, with an approach and a retreat, …_approach.csv and
///   …_retreat.csv
/// - ros: the same with .yaml, a JointTrajectory each
/// - robomimic: robomimic.hdf5, all plans in one, without approach and retreat, which are no
///   demonstration; no file if no plan is executable
///
/// The folder must exist. Each file appears whole, in place of an older one of its
/// name; nothing else in the folder is touched. InputError if the plans cannot be read or the
/// folder not be written.
ExportReport export_plans(const std::filesystem::path& plans, const std::string& format,
                          const std::filesystem::path& folder);

}  // namespace morphe::exports
