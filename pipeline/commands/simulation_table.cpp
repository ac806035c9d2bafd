#include "pipeline/commands/simulation_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/motion/count_with_noun.hpp"
#include "pipeline/commands/text_table.hpp"
#include "stages/simulate/summary.hpp"

namespace morphe::commands {
namespace {

using simulate::Failure;
using simulate::ForecastCount;
using simulate::PlanResult;
using simulate::Rollout;
using simulate::SimulationSummary;
using Json = nlohmann::ordered_json;

std::string format_scaled(double value, double factor, int digits) {
  return !std::isfinite(value) ? std::isnan(value) ? "-" : "inf"
                               : fmt::format("{:.{}f}", factor * value, digits);
}

std::string failures_text(const simulate::FailureCounts& failures) {
  std::string text;
  for (const auto& [name, count] : failures)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, count);
  return text;
}

/// Returns the forecast from the median forces, or "-" without rollouts.
std::string forecast_text(const SimulationSummary& f) {
  if (std::isnan(f.required_force_N)) return "-";
  switch (simulate::forecast_of(f.required_force_N, f.commanded_force_N)) {
    case simulate::Forecast::holds:
      return "holds";
    case simulate::Forecast::near_limit:
      return "near its limit";
    case simulate::Forecast::falls:
      break;
  }
  return "falls";
}

TextTable::Row row_of(const PlanResult& result) {
  TextTable::Row row;
  const SimulationSummary f = summarise(result);
  const bool fit = result.skip_reason == simulate::SkipReason::none;
  row.cells = {
      result.plan,
      fit ? fmt::format("{}/{}", f.held, result.rollouts.size()) : "-",
      f.load_directions > 0 ? fmt::format("{}/{}", f.load_directions_held, f.load_directions) : "-",
      f.tasks > 0 ? fmt::format("{}/{}", f.tasks_done, f.tasks) : "-",
      format_scaled(f.place_error_m, 1e3, 1),
      format_scaled(f.tilt_deg, 1, 1),
      format_scaled(f.palm_offset_m, 1e3, 1),
      format_scaled(f.palm_offset_deg, 1, 1),
      format_scaled(f.droop_m, 1e3, 2),
      format_scaled(f.slip_m, 1e3, 2),
      format_scaled(f.drift_m, 1e3, 3),
      format_scaled(f.arm_error, 1, 2),
      format_scaled(f.hand_error, 1, 2),
      format_scaled(f.contact_delay_s, 1e3, 0),
      format_scaled(f.torque_ratio, 100, 0),
      format_scaled(f.required_force_N, 1, 1),
      format_scaled(f.commanded_force_N, 1, 1),
      forecast_text(f),
      fit ? failures_text(f.failures) : std::string(name_of(result.skip_reason))};
  if (!fit) row.lines.push_back(result.detail);
  if (result.force_scale < 1)
    row.lines.push_back(
        fmt::format("the torque limits of the fingers allow {:.0f} % of the requested grasp force",
                    100 * result.force_scale));
  for (const std::string& note : result.notes) row.lines.push_back("note: " + note);
  for (const Rollout& one : result.rollouts) {
    if (one.lift.failure != Failure::engine_error) continue;
    row.lines.push_back("engine: " + one.lift.detail);
    break;
  }
  return row;
}

std::string share_text(std::size_t part, std::size_t whole) {
  return fmt::format("{} of {} ({:.0f} %)", part, whole,
                     100.0 * static_cast<double>(part) / static_cast<double>(whole));
}

/// Returns how often the forecasts of loads were right, and how many near the limit were held.
std::string forecast_lines(const ForecastCount& forecasts, const char* loads) {
  std::string text;
  if (forecasts.clear > 0)
    text += fmt::format("{} foretold to hold or fall: right in {}\n", loads,
                        share_text(forecasts.correct, forecasts.clear));
  if (forecasts.near_limit > 0)
    text += fmt::format("{} near their limit (ratio of forces 1/{:g} to {:g}): {} held\n", loads,
                        simulate::kForecastMargin, simulate::kForecastMargin,
                        share_text(forecasts.near_limit_held, forecasts.near_limit));
  return text;
}

}  // namespace

std::string simulation_table(const std::vector<PlanResult>& results,
                             const simulate::SimulateOptions& options, std::size_t width) {
  TextTable table;
  table.columns = {{"plan", "", true},
                   {"held", ""},
                   {"six", "directions"},
                   {"task", "done"},
                   {"place", "error mm", false, 1},
                   {"tilt", "deg", false, 1},
                   {"in palm", "mm", false, 1},
                   {"in palm", "deg", false, 1},
                   {"droop", "mm", false, 4},
                   {"slip", "mm"},
                   {"drift", "mm", false, 3},
                   {"arm", "error deg"},
                   {"hand", "error deg"},
                   {"contact", "delay ms", false, 2},
                   {"torque", "%", false, 1},
                   {"required", "force N"},
                   {"commanded", "force N"},
                   {"forecast", "", true},
                   {"failed", "by", true}};
  std::size_t fit = 0, held = 0, rollouts = 0, tasks = 0, done = 0;
  ForecastCount lifts, directions;
  for (const PlanResult& result : results) {
    table.rows.push_back(row_of(result));
    fit += result.skip_reason == simulate::SkipReason::none ? 1U : 0U;
    held += result.held_count();
    rollouts += result.rollouts.size();
    for (const Rollout& one : result.rollouts) {
      tasks += one.task ? 1U : 0U;
      done += one.task && one.task->is_done() ? 1U : 0U;
      lifts.add(one, one.lift);
      for (const simulate::HoldResult& load : one.load_directions) directions.add(one, load);
    }
  }
  std::string text = table_text(table, width);
  for (const std::string& sentence : assumptions(options))
    text += wrap_line("assumed: " + sentence, width, "");
  text += forecast_lines(lifts, "lifts") + forecast_lines(directions, "load directions");
  text += fmt::format("{} simulated, {} skipped: {} of {} held", count_with_noun(fit, "plan"),
                      results.size() - fit, held, count_with_noun(rollouts, "rollout"));
  if (tasks > 0)
    text += fmt::format("; {} of {} carried, put down and let go as planned", done,
                        count_with_noun(tasks, "task"));
  return text + "\n";
}

std::string simulation_json(const std::vector<PlanResult>& results) {
  const auto number = [](double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
  };
  Json plans = Json::array();
  for (const PlanResult& result : results) {
    const SimulationSummary f = summarise(result);
    plans.push_back({{"plan", result.plan},
                     {"not_verified", result.not_verified},
                     {"skip_reason", name_of(result.skip_reason)},
                     {"detail", result.detail},
                     {"rollouts", result.rollouts.size()},
                     {"held", f.held},
                     {"load_directions", f.load_directions},
                     {"load_directions_held", f.load_directions_held},
                     {"tasks", f.tasks},
                     {"tasks_done", f.tasks_done},
                     {"palm_offset_m", number(f.palm_offset_m)},
                     {"palm_offset_deg", number(f.palm_offset_deg)},
                     {"place_error_m", number(f.place_error_m)},
                     {"tilt_deg", number(f.tilt_deg)},
                     {"droop_m", number(f.droop_m)},
                     {"slip_m", number(f.slip_m)},
                     {"drift_m", number(f.drift_m)},
                     {"arm_error", number(f.arm_error)},
                     {"hand_error", number(f.hand_error)},
                     {"contact_delay_s", number(f.contact_delay_s)},
                     {"torque_ratio", number(f.torque_ratio)},
                     {"contact_source", name_of(result.contact_source)},
                     {"force_scale", result.force_scale},
                     {"required_force_N", number(f.required_force_N)},
                     {"commanded_force_N", number(f.commanded_force_N)},
                     {"forecasts", f.forecasts.clear},
                     {"correct_forecasts", f.forecasts.correct},
                     {"near_limit", f.forecasts.near_limit},
                     {"near_limit_held", f.forecasts.near_limit_held},
                     {"failures", Json(f.failures)}});
  }
  return Json{{"plans", plans}}.dump(2) + "\n";
}

}  // namespace morphe::commands
