#include "pipeline/report/physics_json.hpp"

#include <fmt/format.h>

#include "core/store/fingerprint.hpp"
#include "pipeline/report/numbers_json.hpp"
#include "stages/simulate/figures.hpp"
#include "stages/simulate/results.hpp"

namespace morphe::report {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json summary_of(const simulate::StoredResult& stored) {
  const simulate::PlanResult& result = stored.result;
  const simulate::Figures figures = simulate::figures_of(result);
  Json json = {{"unfit", name_of(result.unfit)},
               {"detail", result.detail},
               {"engine", stored.engine},
               {"squeeze", result.planned_squeeze ? "plan" : "nearest"},
               {"rollouts", result.rollouts.size()},
               {"held", figures.held},
               {"failures", figures.failures},
               {"directions", figures.directions},
               {"directions_held", figures.directions_held},
               {"direction_failures", figures.direction_failures}};
  const auto add = [&](const char* name, double value) { json[name] = number_json(value); };
  add("sag_m", figures.sag_m);
  add("slip_m", figures.slip_m);
  add("creep_m", figures.creep_m);
  add("arm_error", figures.arm_error);
  add("hand_error", figures.hand_error);
  add("torque_share", figures.torque_share);
  add("needed_N", figures.needed_N);
  add("given_N", figures.given_N);
  const simulate::Variation first =
      result.rollouts.empty() ? simulate::Variation() : result.rollouts.front().variation;
  add("friction", first.friction);
  add("torsion_m", first.torsion_m);
  add("mass_kg", first.mass_kg);
  return json;
}

}  // namespace

std::vector<fs::path> physics_folders(const std::vector<fs::path>& named, const fs::path& plans) {
  if (!named.empty()) return named;
  const fs::path beside = plans.parent_path() / "physics";
  return fs::is_directory(beside) ? std::vector{beside} : std::vector<fs::path>();
}

Json physics_json(const std::vector<fs::path>& folders, const RobotTable& robot, const Plan& plan,
                  std::vector<std::string>& notes) {
  const std::string name = fmt::format("{}_{:03}.json", plan.demonstration, plan.movement.index);
  bool other = false;
  for (const fs::path& folder : folders) {
    if (!fs::is_regular_file(folder / name)) continue;
    const simulate::StoredResult stored = simulate::stored_result(folder / name);
    if (stored.result.plan_sha256 == store::fingerprint(robot, plan)) return summary_of(stored);
    other = true;
  }
  if (other)
    notes.push_back(fmt::format("{}/{:03}: what was simulated is another plan, and left out",
                                plan.demonstration, plan.movement.index));
  return nullptr;
}

}  // namespace morphe::report
