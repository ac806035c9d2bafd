#include "pipeline/planning/verify_recordings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/files/sha256.hpp"
#include "core/parallel/ordered_parallel_map.hpp"
#include "core/store/demonstration_file.hpp"
#include "core/store/plan_file.hpp"
#include "pipeline/planning/begin_plan.hpp"
#include "pipeline/planning/plan_movement.hpp"
#include "pipeline/planning/run_config.hpp"

namespace morphe::planning {
namespace {

constexpr double kSameTime_s = 1e-6;

/// A recording, absent if the dataset does not have it, and its plans.
struct RecordedPlans {
  std::string name;
  std::optional<Demonstration> demonstration;
  std::vector<Plan> plans;
};

verify::Violation violation(const std::string& plan, const std::string& subject, double value,
                            double limit) {
  return {plan, -1, 0, "recording", subject, value, limit, {}};
}

/// Returns the movement of a recording from which a plan was made: the one around the plan's
/// interval. (A plan may end earlier, and be a part of a split one.)
const Movement* movement_of(const Reconstruction& recorded, const Plan& plan) {
  const auto around = [&](const Movement& movement) {
    return plan.movement.begin_s >= movement.begin_s - kSameTime_s &&
           plan.movement.end_s <= movement.end_s + kSameTime_s;
  };
  const auto found = std::ranges::find_if(recorded.movements, around);
  return found == recorded.movements.end() ? nullptr : &*found;
}

/// Returns the plan of a movement as far as its recording determines it.
Plan expected_plan(const PlanningInputs& planner, const Reconstruction& recorded, const Plan& plan,
                   Movement movement) {
  if (plan.delivered || planner.config.split) {
    movement.begin_s = plan.movement.begin_s;
    movement.end_s = plan.movement.end_s;
  }
  return place_movement(planner, recorded.on_robot_side, recorded.motion, movement,
                        plan.goals.base_offset.value_or(Vec3::Zero()));
}

std::vector<verify::Violation> compare(const PlanningInputs& planner, const RecordedPlans& item) {
  if (!item.demonstration)
    return {violation(item.name, "is not in the dataset", kUnknown, kUnknown)};
  const Reconstruction recorded = reconstruct_demonstration(planner, *item.demonstration);
  std::vector<verify::Violation> all;
  std::size_t planned = 0;
  const Movement* last = nullptr;
  for (const Plan& plan : item.plans) {
    const std::string path = fmt::format("{}/{:03}", item.name, plan.movement.index);
    const Movement* movement = movement_of(recorded, plan);
    if (recorded.movements.empty()) {
      const Plan none = fail(begin_plan(*item.demonstration, {}, planner.config.check.tolerances),
                             {Reason::no_movement, ""});
      for (verify::Violation& each : verify::verify_recorded(path, plan, none))
        all.push_back(std::move(each));
      continue;
    }
    if (!movement) {
      all.push_back(violation(path, "phases", kUnknown, kUnknown));
      continue;
    }
    planned += movement != last ? 1 : 0;
    last = movement;
    const Plan expected = expected_plan(planner, recorded, plan, *movement);
    for (verify::Violation& each : verify::verify_recorded(path, plan, expected))
      all.push_back(std::move(each));
  }
  if (planned != recorded.movements.size())
    all.push_back(violation(item.name, "movements", static_cast<double>(planned),
                            static_cast<double>(recorded.movements.size())));
  return all;
}

/// Reads the plans of the next demonstration, and its recording; null at the end.
std::unique_ptr<RecordedPlans> read_next(const store::PlanReader& plans,
                                         const store::DemonstrationReader& recordings,
                                         std::size_t& index) {
  const std::vector<std::string>& paths = plans.plan_paths();
  if (index == paths.size()) return nullptr;
  auto item = std::make_unique<RecordedPlans>();
  item->name = paths[index].substr(0, paths[index].find('/'));
  while (index < paths.size() && paths[index].starts_with(item->name + "/"))
    item->plans.push_back(plans.read(index++));
  const std::vector<std::string>& names = recordings.names();
  if (std::ranges::find(names, item->name) != names.end())
    item->demonstration = recordings.read(item->name);
  return item;
}

}  // namespace

void verify_recordings(const std::filesystem::path& plans, const std::filesystem::path& dataset,
                       int jobs, verify::VerifyReport& report) {
  const RunConfig config = stored_config(plans);
  const PlanningInputs planner{config.loaded.options, config.loaded.robot};
  const store::PlanReader reader(plans);
  const store::DemonstrationReader recordings(dataset);
  if (files::sha256_of_file(dataset) != reader.header().dataset_sha256)
    report.violations.push_back(violation("", "dataset_sha256", kUnknown, kUnknown));
  using Violations = std::vector<verify::Violation>;
  parallel::OrderedParallelMap<RecordedPlans, Violations> map;
  map.next = [&, index = std::size_t{0}]() mutable { return read_next(reader, recordings, index); };
  map.work = [&](const RecordedPlans& item) {
    return std::make_unique<Violations>(compare(planner, item));
  };
  map.write = [&](const Violations& found) {
    report.violations.insert(report.violations.end(), found.begin(), found.end());
  };
  parallel::run(map, jobs);
  report.looked_at.recordings = true;
}

}  // namespace morphe::planning
