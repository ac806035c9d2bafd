#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/report/selection.hpp"

namespace morphe::report {

struct ReportRequest {
  struct Run {
    std::filesystem::path plans;  ///< plans.h5
    std::string name;             ///< what the page calls it
  };
  std::vector<Run> runs;
  Selection selection;           ///< of each run's plans
  std::filesystem::path meshes;  ///< folder of the robot's meshes, empty: capsules alone
  std::vector<std::filesystem::path> physics;  ///< folders of what was simulated (physics_json.hpp)
  int jobs = 1;
};

struct ReportSummary {
  std::size_t shown = 0;
  std::vector<std::string> notes;  ///< sentences: what was left out, meshes that were not found
};

/// One HTML file that plays every plan, from disk, without a network (page/README.md). It is
/// written plan by plan and appears when it is whole. Same files, same bytes. InputError: a
/// plans.h5 that cannot be read, or a page that cannot be written.
ReportSummary write_report(const ReportRequest& request, const std::filesystem::path& page);

/// A filmstrip (filmstrip.hpp) of each plan selected, <demonstration>_<000>.svg, with several runs
/// <name>_<demonstration>_<000>.svg, in a folder that exists. The files' names.
std::vector<std::string> write_filmstrips(const ReportRequest& request,
                                          const std::filesystem::path& folder);

}  // namespace morphe::report
