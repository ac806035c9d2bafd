#include "pipeline/report/simulation_summary_json.hpp"

#include <fmt/format.h>

#include "core/store/fingerprint.hpp"
#include "pipeline/report/numbers_json.hpp"
#include "stages/simulate/results.hpp"
#include "stages/simulate/summary.hpp"

namespace morphe::report {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json summary_of(const simulate::StoredResult& stored) {
  const simulate::PlanResult& result = stored.result;
  const simulate::SimulationSummary summary = simulate::summarise(result);
  Json json = {{"skip_reason", name_of(result.skip_reason)},
               {"detail", result.detail},
               {"engine", stored.engine},
               {"contact_source", name_of(result.contact_source)},
               {"rollouts", result.rollouts.size()},
               {"held", summary.held},
               {"tasks", summary.tasks},
               {"tasks_done", summary.tasks_done},
               {"failures", summary.failures},
               {"load_directions", summary.load_directions},
               {"load_directions_held", summary.load_directions_held},
               {"direction_failures", summary.direction_failures}};
  const auto add = [&](const char* name, double value) { json[name] = number_json(value); };
  add("droop_m", summary.droop_m);
  add("slip_m", summary.slip_m);
  add("drift_m", summary.drift_m);
  add("palm_offset_m", summary.palm_offset_m);
  add("place_error_m", summary.place_error_m);
  add("tilt_deg", summary.tilt_deg);
  add("arm_error", summary.arm_error);
  add("hand_error", summary.hand_error);
  add("torque_ratio", summary.torque_ratio);
  add("required_force_N", summary.required_force_N);
  add("commanded_force_N", summary.commanded_force_N);
  const simulate::Variation first =
      result.rollouts.empty() ? simulate::Variation() : result.rollouts.front().variation;
  add("friction", first.friction);
  add("torsional_friction_m", first.torsional_friction_m);
  add("mass_kg", first.mass_kg);
  return json;
}

}  // namespace

std::vector<fs::path> simulation_folders(const std::vector<fs::path>& named,
                                         const fs::path& plans) {
  if (!named.empty()) return named;
  const fs::path default_folder = plans.parent_path() / "physics";
  return fs::is_directory(default_folder) ? std::vector{default_folder} : std::vector<fs::path>();
}

Json simulation_summary_json(const std::vector<fs::path>& folders, const RobotModel& robot,
                             const Plan& plan, std::vector<std::string>& notes) {
  const std::string name = fmt::format("{}_{:03}.json", plan.demonstration, plan.movement.index);
  bool found_other_plan = false;
  for (const fs::path& folder : folders) {
    if (!fs::is_regular_file(folder / name)) continue;
    const simulate::StoredResult stored = simulate::load_result(folder / name);
    if (stored.result.plan_sha256 == store::fingerprint(robot, plan)) return summary_of(stored);
    found_other_plan = true;
  }
  if (found_other_plan)
    notes.push_back(fmt::format("{}/{:03}: skipped: the simulation belongs to another plan",
                                plan.demonstration, plan.movement.index));
  return nullptr;
}

}  // namespace morphe::report
