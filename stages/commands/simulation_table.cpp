#include "stages/commands/simulation_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "pipeline/math/statistics.hpp"
#include "pipeline/motion/counted.hpp"
#include "stages/commands/text_table.hpp"

namespace morphe::commands {
namespace {

using simulate::Failure;
using simulate::PlanResult;
using simulate::Rollout;
using Json = nlohmann::ordered_json;

std::vector<double> each(const PlanResult& result,
                         const std::function<double(const Rollout&)>& of) {
  std::vector<double> values;
  for (const Rollout& one : result.rollouts) {
    if (one.lift.failure != Failure::engine) values.push_back(of(one));
  }
  return values;
}

/// What a plan's rollouts come to.
struct Figures {
  std::size_t held = 0, directions_held = 0, directions = 0;
  double sag_m = kNotSeen, slip_m = kNotSeen, creep_m = kNotSeen;  ///< medians of those that held
  double arm_error = kNotSeen, hand_error = kNotSeen, torque_share = kNotSeen;  ///< largest
  double contact_s = kNotSeen;  ///< median of the first touch less the planned one
  double needed_N = kNotSeen, given_N = kNotSeen;  ///< medians, as it is lifted
  std::map<std::string, int> failures;
};

/// How often the newtons told hold from fall, of loads that came.
struct Foretold {
  std::size_t right = 0, all = 0;
  void add(const Rollout& one, const simulate::Holding& load) {
    if (!simulate::was_loaded(load.failure)) return;
    ++all;
    right += one.foretold(load) == load.held() ? 1U : 0U;
  }
};

double largest(const std::vector<double>& values) {
  return values.empty() ? kNotSeen : *std::ranges::max_element(values);
}

double middle(std::vector<double> values) {
  return values.empty() ? kNotSeen : math::median(values);
}

double median_of_held(const PlanResult& result, const std::function<double(const Rollout&)>& of) {
  std::vector<double> values;
  for (const Rollout& one : result.rollouts) {
    if (one.lift.held()) values.push_back(of(one));
  }
  return middle(std::move(values));
}

Figures figures_of(const PlanResult& result) {
  Figures figures;
  figures.held = result.held();
  for (const Rollout& one : result.rollouts) {
    if (!one.lift.held()) ++figures.failures[std::string(name_of(one.lift.failure))];
    figures.directions += one.directions.size();
    for (const simulate::Holding& holding : one.directions)
      figures.directions_held += holding.held() ? 1U : 0U;
  }
  figures.sag_m = median_of_held(result, [](const Rollout& r) { return r.lift.sag.distance_m; });
  figures.slip_m = median_of_held(result, [](const Rollout& r) { return r.lift.slip_m; });
  figures.creep_m =
      median_of_held(result, [](const Rollout& r) { return r.lift.creep.distance_m; });
  figures.arm_error = largest(each(result, [](const Rollout& r) { return r.arm_error; }));
  figures.hand_error = largest(each(result, [](const Rollout& r) { return r.hand_error; }));
  figures.torque_share = largest(each(result, [](const Rollout& r) { return r.torque_share; }));
  figures.needed_N = middle(each(result, [](const Rollout& r) { return r.lift.needed_N; }));
  figures.given_N = middle(each(result, [](const Rollout& r) { return r.given_N; }));
  std::vector<double> late;
  for (const Rollout& one : result.rollouts) {
    if (std::isfinite(one.contact_s)) late.push_back(one.contact_s - result.planned_contact_s);
  }
  figures.contact_s = middle(std::move(late));
  return figures;
}

Foretold foretold_of(const PlanResult& result) {
  Foretold lifts;
  for (const Rollout& one : result.rollouts) lifts.add(one, one.lift);
  return lifts;
}

std::string shown(double value, double factor, int digits) {
  return !std::isfinite(value) ? std::isnan(value) ? "-" : "inf"
                               : fmt::format("{:.{}f}", factor * value, digits);
}

std::string failures_text(const std::map<std::string, int>& failures) {
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
                     {"foretold", foretold_of(result).right},
                     {"failures", Json(f.failures)}});
  }
  return Json{{"plans", plans}}.dump(2) + "\n";
}

}  // namespace morphe::commands
