#include "pipeline/report/opened_run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/config/fields.hpp"
#include "core/motion/input_error.hpp"
#include "stages/map/placement.hpp"

namespace morphe::report {
namespace {

/// As the file's config has it; a hand alone has goals in the human hand's frame, not in the
/// world's.
std::optional<Eigen::Matrix3d> world_from_base(const std::string& config,
                                               const robot::Robot& robot) {
  if (map::hand_alone(robot)) return std::nullopt;
  try {
    const config::ConfigNode node = config::ConfigNode::parse(config, "@config");
    map::PlacementOptions placement;
    if (node.has("placement")) config::read_options(node["placement"], placement);
    return map::rotation_of(placement);
  } catch (const InputError&) {
    return std::nullopt;  // another version's
  }
}

bool any_called(const std::vector<OpenedRun>& runs, const std::string& pattern) {
  return std::ranges::any_of(runs, [&](const OpenedRun& run) {
    return std::ranges::any_of(run.reader->plan_paths(),
                               [&](const std::string& path) { return matches(path, pattern); });
  });
}

}  // namespace

std::vector<OpenedRun> open_runs(const ReportRequest& request) {
  std::vector<OpenedRun> runs;
  for (const ReportRequest::Run& named : request.runs) {
    OpenedRun run;
    run.named = named;
    run.reader = std::make_unique<store::PlanReader>(named.plans);
    run.robot = robot::Robot(run.reader->robot());
    run.world_from_base = world_from_base(run.reader->header().config, run.robot);
    run.selected = select_plans(*run.reader, request.selection);
    runs.push_back(std::move(run));
  }
  const std::string& pattern = request.selection.pattern;
  if (!pattern.empty() && !any_called(runs, pattern))
    throw InputError(fmt::format("--plans: no plan is called '{}'", pattern));
  return runs;
}

}  // namespace morphe::report
