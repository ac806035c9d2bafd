#include "pipeline/commands/simulation_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/motion/counted.hpp"
#include "pipeline/commands/text_table.hpp"
#include "stages/simulate/figures.hpp"

namespace morphe::commands {
namespace {

using simulate::Failure;
using simulate::Figures;
using simulate::Foretold;
using simulate::PlanResult;
using simulate::Rollout;
using Json = nlohmann::ordered_json;

std::string shown(double value, double factor, int digits) {
  return !std::isfinite(value) ? std::isnan(value) ? "-" : "inf"
                               : fmt::format("{:.{}f}", factor * value, digits);
}

std::string failures_text(const simulate::FailureCounts& failures) {
  std::string text;
  for (const auto& [name, count] : failures)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, count);
  return text;
}

TextTable::Row row_of(const PlanResult& result) {
  TextTable::Row row;
  const Figures f = figures_of(result);
  const bool fit = result.unfit == simulate::Unfit::none;
  row.cells = {result.plan,
               fit ? fmt::format("{}/{}", f.held, result.rollouts.size()) : "-",
               f.directions > 0 ? fmt::format("{}/{}", f.directions_held, f.directions) : "-",
               shown(f.sag_m, 1e3, 2),
               shown(f.slip_m, 1e3, 2),
               shown(f.creep_m, 1e3, 3),
               shown(f.arm_error, 1, 2),
               shown(f.hand_error, 1, 2),
               shown(f.contact_s, 1e3, 0),
               shown(f.torque_share, 100, 0),
               shown(f.needed_N, 1, 1),
               shown(f.given_N, 1, 1),
               fit ? failures_text(f.failures) : std::string(name_of(result.unfit))};
  if (!fit) row.lines.push_back(result.detail);
  if (result.force_share < 1)
    row.lines.push_back(fmt::format("the fingers' torques leave {:.0f} % of the squeeze asked for",
                                    100 * result.force_share));
  for (const std::string& note : result.notes) row.lines.push_back("note: " + note);
  for (const Rollout& one : result.rollouts) {
    if (one.lift.failure != Failure::engine) continue;
    row.lines.push_back("engine: " + one.lift.detail);
    break;
  }
  return row;
}

}  // namespace

std::string simulation_table(const std::vector<PlanResult>& results,
                             const simulate::SimulateOptions& options, std::size_t width) {
  TextTable table;
  table.columns = {
      {"plan", "", true},        {"held", ""},          {"six", "directions"},
      {"sag", "mm", false, 4},   {"slip", "mm"},        {"creep", "mm", false, 3},
      {"arm", "error deg"},      {"hand", "error deg"}, {"contact", "late ms", false, 2},
      {"torque", "%", false, 1}, {"needed", "N"},       {"given", "N"},
      {"failed", "by", true}};
  std::size_t fit = 0, held = 0, rollouts = 0;
  Foretold lifts, directions;
  for (const PlanResult& result : results) {
    table.rows.push_back(row_of(result));
    fit += result.unfit == simulate::Unfit::none ? 1U : 0U;
    held += result.held();
    rollouts += result.rollouts.size();
    for (const Rollout& one : result.rollouts) {
      lifts.add(one, one.lift);
      for (const simulate::Holding& load : one.directions) directions.add(one, load);
    }
  }
  std::string text = table_text(table, width);
  for (const std::string& sentence : assumptions(options))
    text += folded("assumed: " + sentence, width, "");
  for (const auto& [what, foretold] :
       {std::pair{"lifts", lifts}, std::pair{"directions", directions}}) {
    if (foretold.all == 0) continue;
    text += fmt::format(
        "needed and given newtons tell hold from fall in {} of {} {} ({:.0f} %)\n", foretold.right,
        foretold.all, what,
        100.0 * static_cast<double>(foretold.right) / static_cast<double>(foretold.all));
  }
  return text + fmt::format("{} simulated, {} not: {} of {} held\n", counted(fit, "plan"),
                            results.size() - fit, held, counted(rollouts, "rollout"));
}

std::string simulation_json(const std::vector<PlanResult>& results) {
  const auto number = [](double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
  };
  Json plans = Json::array();
  for (const PlanResult& result : results) {
    const Figures f = figures_of(result);
    plans.push_back({{"plan", result.plan},
                     {"unfit", name_of(result.unfit)},
                     {"detail", result.detail},
                     {"rollouts", result.rollouts.size()},
                     {"held", f.held},
                     {"directions", f.directions},
                     {"directions_held", f.directions_held},
                     {"sag_m", number(f.sag_m)},
                     {"slip_m", number(f.slip_m)},
                     {"creep_m", number(f.creep_m)},
                     {"arm_error", number(f.arm_error)},
                     {"hand_error", number(f.hand_error)},
                     {"contact_late_s", number(f.contact_s)},
                     {"torque_share", number(f.torque_share)},
                     {"squeeze", result.planned_squeeze ? "plan" : "nearest"},
                     {"force_share", result.force_share},
                     {"needed_N", number(f.needed_N)},
                     {"given_N", number(f.given_N)},
                     {"foretold", f.foretold.right},
                     {"failures", Json(f.failures)}});
  }
  return Json{{"plans", plans}}.dump(2) + "\n";
}

}  // namespace morphe::commands
