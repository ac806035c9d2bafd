#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/report/selection.hpp"

namespace morphe::report {

/// The inputs of a report.
struct ReportRequest {
  /// A run that the report shows.
  struct Run {
    std::filesystem::path plans;  ///< plans.h5
    std::string name;             ///< name on the page
  };
  /// The runs, in the order of the page.
  std::vector<Run> runs;
  /// Selection of the plans of each run.
  Selection selection;
  /// Folder of the robot's meshes, empty to show only capsules.
  std::filesystem::path meshes;
  /// Folders of simulation results (simulation_summary_json.hpp).
  std::vector<std::filesystem::path> physics;
  /// The number of threads.
  int jobs = 1;
};

/// The result of writing a report.
struct ReportSummary {
  /// The number of plans shown.
  std::size_t shown = 0;
  /// Sentences about omitted plans and meshes that were not found.
  std::vector<std::string> notes;
};

/// Writes one HTML file that plays every plan from disk, without a network (page/README.md). It is
/// written plan by plan and appears at its path when it is complete. Equal files give equal bytes.
/// Throws InputError if a plans.h5 cannot be read or the page cannot be written.
ReportSummary write_report(const ReportRequest& request, const std::filesystem::path& page);

/// Writes a filmstrip (filmstrip.hpp) of each selected plan, <demonstration>_<000>.svg, or
/// <name>_<demonstration>_<000>.svg for several runs, into an existing folder. Returns the names of
/// the files.
std::vector<std::string> write_filmstrips(const ReportRequest& request,
                                          const std::filesystem::path& folder);

}  // namespace morphe::report
