#include <fmt/format.h>

#include <algorithm>

#include "core/files/atomic_file.hpp"
#include "pipeline/report/filmstrip.hpp"
#include "pipeline/report/opened_run.hpp"
#include "pipeline/report/report.hpp"

namespace morphe::report {
std::vector<std::string> write_filmstrips(const ReportRequest& request,
                                          const std::filesystem::path& folder) {
  const std::vector<OpenedRun> runs = open_runs(request);
  std::vector<std::string> names;
  for (const OpenedRun& run : runs) {
    for (const int k : run.selected.plans) {
      const std::string& path = run.reader->plan_paths()[k];
      std::string name = runs.size() > 1 ? fmt::format("{}_{}.svg", run.request.name, path)
                                         : fmt::format("{}.svg", path);
      std::ranges::replace(name, '/', '_');
      const Plan plan = run.reader->read(k);
      files::write_atomically(
          folder / name,
          filmstrip(run.robot, plan, path, make_plan_view(run.robot, run.world_from_base, plan),
                    !run.request.not_verified.empty()));
      names.push_back(name);
    }
  }
  return names;
}

}  // namespace morphe::report
