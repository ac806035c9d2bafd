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
    std::string name;             ///< name of the run on the page
    std::string not_verified;  ///< why its plans are not verified, as "was not …"; "" if they are
  };
  std::vector<Run> runs;         ///< in the order of the page
  Selection selection;           ///< of the plans of each run
  std::filesystem::path meshes;  ///< folder of the robots' meshes, empty to show only capsules
  std::vector<std::filesystem::path> physics;  ///< folders of simulation results
  int jobs = 1;                                ///< number of threads
};

/// The result of writing a report.
struct ReportSummary {
  std::size_t shown = 0;           ///< number of plans on the page
  std::vector<std::string> notes;  ///< sentences about omitted plans and meshes that were not found
};

/// Writes one HTML file that plays every selected plan, without a network (page/README.md). The
/// file appears at its path when it is complete. Equal plans.h5, meshes and results of simulations
/// give equal bytes. Throws InputError if a plans.h5 cannot be read or the page cannot be written.
ReportSummary write_report(const ReportRequest& request, const std::filesystem::path& page);

/// Writes a filmstrip of each selected plan into an existing folder: <demonstration>_<000>.svg, or
/// <name>_<demonstration>_<000>.svg for several runs. Returns the names of the files.
std::vector<std::string> write_filmstrips(const ReportRequest& request,
                                          const std::filesystem::path& folder);

}  // namespace morphe::report
