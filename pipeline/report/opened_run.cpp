#include "pipeline/report/opened_run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/config/fields.hpp"
#include "core/config/spelling_hint.hpp"
#include "core/motion/input_error.hpp"
#include "stages/map/placement.hpp"

namespace morphe::report {
namespace {

/// Returns the rotation of the base from the config in the file; empty for a config of another
/// version, and for a hand without an arm, whose goals are in the frame of the human hand.
std::optional<Eigen::Matrix3d> world_from_base(const std::string& config,
                                               const robot::Robot& robot) {
  if (map::is_hand_only(robot)) return std::nullopt;
  try {
    const config::ConfigNode node = config::ConfigNode::parse(config, "@config");
    map::PlacementOptions placement;
    if (node.has("placement")) config::read_options(node["placement"], placement);
    return map::rotation_of(placement);
  } catch (const InputError&) {
    return std::nullopt;  // config of another version
  }
}

bool any_plan_matches(const std::vector<OpenedRun>& runs, const std::string& pattern) {
  return std::ranges::any_of(runs, [&](const OpenedRun& run) {
    return std::ranges::any_of(run.reader->plan_paths(), [&](const std::string& path) {
      return plan_matches(path, pattern);
    });
  });
}

/// Returns the names of all plans and of their demonstrations.
std::vector<std::string> plan_names(const std::vector<OpenedRun>& runs) {
  std::vector<std::string> names;
  for (const OpenedRun& run : runs)
    for (const std::string& path : run.reader->plan_paths()) {
      names.push_back(path);
      names.push_back(path.substr(0, path.rfind('/')));
    }
  return names;
}

}  // namespace

std::vector<OpenedRun> open_runs(const ReportRequest& request) {
  std::vector<OpenedRun> runs;
  for (const ReportRequest::Run& requested : request.runs) {
    OpenedRun& run = runs.emplace_back();
    run.request = requested;
    run.reader = std::make_unique<store::PlanReader>(requested.plans);
    run.robot = robot::Robot(run.reader->robot());
    run.world_from_base = world_from_base(run.reader->header().config, run.robot);
    run.advice = explain::advice_context(run.reader->header().config);
    run.selected = select_plans(*run.reader, request.selection);
  }
  const std::string& pattern = request.selection.pattern;
  if (!pattern.empty() && !any_plan_matches(runs, pattern))
    throw InputError(fmt::format("--plans: no plan has the name '{}'{}", pattern,
                                 config::spelling_hint(pattern, plan_names(runs))));
  return runs;
}

}  // namespace morphe::report
