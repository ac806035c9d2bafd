#include "pipeline/commands/plan_row.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/config/spelling_hint.hpp"
#include "core/motion/arm_estimate.hpp"
#include "core/motion/assumption_text.hpp"
#include "core/motion/finding_text.hpp"
#include "core/motion/flag_text.hpp"
#include "core/motion/input_error.hpp"
#include "pipeline/commands/certificate_json.hpp"
#include "pipeline/commands/scene_remarks.hpp"
#include "pipeline/commands/text_table.hpp"
#include "pipeline/explain/advice.hpp"
#include "pipeline/planning/plan_branch.hpp"
#include "pipeline/report/selection.hpp"

namespace morphe::commands {
namespace {

using nlohmann::json;

std::string in_mm(double value) { return std::isnan(value) ? "-" : fmt::format("{:.1f}", value); }

double mean_mm(const JointRows& errors) {
  double sum = 0;
  int count = 0;
  for (const double error : errors.reshaped()) {
    if (std::isnan(error)) continue;
    sum += error;
    ++count;
  }
  return count > 0 ? 1e3 * sum / count : kUnknown;
}

/// Describes goals out of reach: the errors of the tips and the smallest attainable errors.
std::string reach_line(const Plan& plan) {
  const JointRows& nearest = plan.mapped.least_attainable_error;
  if (std::isnan(mean_mm(nearest))) return "";
  const JointRows unreachable = nearest.array().isNaN().select(kUnknown, plan.mapped.tip_error);
  return fmt::format(
      "goals out of reach: mean tip error {} mm, smallest possible {} mm; mean over all goals {} "
      "mm",
      in_mm(mean_mm(unreachable)), in_mm(mean_mm(nearest)), in_mm(mean_mm(plan.mapped.tip_error)));
}

std::vector<std::string> lines_of(const robot::Robot& robot, const Plan& plan,
                                  const explain::AdviceContext& context) {
  std::vector<std::string> lines;
  if (plan.reason != Reason::none) {
    const bool has_reason = plan.detail.starts_with(fmt::format("{}:", name_of(plan.reason)));
    lines.push_back(has_reason ? plan.detail
                               : fmt::format("{}: {}", name_of(plan.reason), plan.detail));
    for (const explain::Advice& advice : explain::advice_for(robot, plan, context))
      lines.push_back("try: " + explain::text_of(advice));
  } else if (!plan.detail.empty()) {
    lines.push_back("note: " + plan.detail);
  }
  for (const RecordingFlag& flag : plan.flags) lines.push_back("flag: " + sentence(flag));
  if (const std::string reach = reach_line(plan); !reach.empty()) lines.push_back(reach);
  for (const Finding& finding : plan.findings)
    lines.push_back(fmt::format("found: {} ({})", sentence(finding), name_of(finding.cause)));
  return lines;
}

json matrix_json(const Pose& pose) {
  json rows = json::array();
  for (int row = 0; row < 3; ++row)
    for (int col = 0; col < 4; ++col) rows.push_back(pose.matrix()(row, col));
  return rows;
}

double number_of(const json& value) { return value.is_null() ? kUnknown : value.get<double>(); }

Pose pose_of(const json& value) {
  Pose pose = Pose::Identity();
  for (int row = 0; row < 3; ++row)
    for (int col = 0; col < 4; ++col) pose.matrix()(row, col) = number_of(value.at(4 * row + col));
  return pose;
}

json branch_json(const ArmBranch& branch) {
  if (!branch.number) return nullptr;
  return {{"number", *branch.number}, {"words", branch.words}, {"changes", branch.changes}};
}

ArmBranch branch_of_json(const json& value) {
  ArmBranch branch;
  if (value.is_null()) return branch;
  branch.number = value.at("number").get<int>();
  value.at("words").get_to(branch.words);
  value.at("changes").get_to(branch.changes);
  return branch;
}

/// A figure's column of the table: the fields are those of TextTable::Column.
struct FigureColumn {
  const char *key, *top, *subhead;
  int drop_priority;
};
constexpr std::array<FigureColumn, 13> kColumns{{{"mapped_tip_error", "mapped", "tips mm", 9},
                                                 {"unreachable_share", "out of", "reach %", 3},
                                                 {"max_joint_step", "mapped", "step rad", 13},
                                                 {"tip_error_grasp", "tips at", "grasp mm", 5},
                                                 {"tip_error_max", "tips", "max mm", 1},
                                                 {"humanlikeness", "human-", "like cm^2", 12},
                                                 {"upper_arm_error", "upper arm", "mean deg", 6},
                                                 {"forearm_error", "forearm", "mean deg", 8},
                                                 {"swivel_error", "swivel", "mean deg", 10},
                                                 {"palm_error", "palm", "mean deg", 4},
                                                 {"wrist_speed_correlation", "wrist", "speed r", 7},
                                                 {"clearance", "clearance", "mm", 11},
                                                 {"duration_ratio", "duration", "ratio", 2}}};

/// Returns the demonstration of "<demonstration>/<000>".
std::string demonstration_of(const std::string& plan_name) {
  return plan_name.substr(0, plan_name.rfind('/'));
}

}  // namespace

PlanRow row_of(const robot::Robot& robot, const Plan& plan, const explain::AdviceContext& context) {
  PlanRow row;
  row.name = fmt::format("{}/{:03}", plan.demonstration, plan.movement.index);
  row.status = plan.executable() && plan.repaired ? "repaired" : name_of(plan.status());
  row.reason = name_of(plan.reason);
  row.figures = figures_of(robot, plan);
  row.arm_estimated = is_arm_estimated(plan.goals);
  row.lines = lines_of(robot, plan, context);
  row.branch = plan.branch.number ? plan.branch : planning::branch_of(robot, plan);
  row.world = plan.reference_frames;
  row.remarks = scene_remarks(plan);
  row.assumptions = plan_assumptions(plan);
  row.clearances = plan.certificate.clearance_by_kind;
  return row;
}

void distrust(PlanRow& row, const std::string& violation) {
  if (violation.empty()) return;
  PlanRow rest;
  rest.name = row.name;
  rest.status = kNotVerified;
  rest.figures.fill(kUnknown);
  rest.lines = {"rejected by verify: " + violation};
  row = std::move(rest);
}

std::string row_to_json(const PlanRow& row) {
  const WorldFrames& world = row.world;
  return json{{"name", row.name},
              {"status", row.status},
              {"reason", row.reason},
              {"figures", row.figures},
              {"arm_estimated", row.arm_estimated},
              {"lines", row.lines},
              {"recording", matrix_json(world.base_from_world)},
              {"table", matrix_json(world.base_from_table)},
              {"target", matrix_json(world.base_from_target)},
              {"shoulder", {world.shoulder.x(), world.shoulder.y(), world.shoulder.z()}},
              {"remarks", row.remarks},
              {"branch", branch_json(row.branch)},
              {"assumptions", assumptions_json(row.assumptions)},
              {"clearances", clearances_json(row.clearances)}}
      .dump(-1, ' ', false, json::error_handler_t::replace);
}

PlanRow row_from_json(const std::string& text) {
  PlanRow row;
  try {
    const json row_json = json::parse(text);
    row_json.at("name").get_to(row.name);
    row_json.at("status").get_to(row.status);
    row_json.at("reason").get_to(row.reason);
    for (int k = 0; k < kPlanFigureCount; ++k)
      row.figures[k] = number_of(row_json.at("figures").at(k));
    row_json.at("arm_estimated").get_to(row.arm_estimated);
    row_json.at("lines").get_to(row.lines);
    row.world.base_from_world = pose_of(row_json.at("recording"));
    row.world.base_from_table = pose_of(row_json.at("table"));
    row.world.base_from_target = pose_of(row_json.at("target"));
    for (int k = 0; k < 3; ++k) row.world.shoulder[k] = number_of(row_json.at("shoulder").at(k));
    row_json.at("remarks").get_to(row.remarks);
    if (row_json.contains("branch")) row.branch = branch_of_json(row_json.at("branch"));
    row.assumptions = assumptions_of_json(row_json.at("assumptions"));
    row.clearances = clearances_of_json(row_json.at("clearances"));
  } catch (const nlohmann::json::exception&) {
    throw InputError("a row of the journal's table is damaged; plan again with --fresh");
  }
  return row;
}

std::vector<std::string> sort_keys() {
  std::vector<std::string> keys{"name"};
  for (const PlanFigure& figure : plan_figures()) keys.emplace_back(figure.key);
  return keys;
}

std::vector<std::string> filter_words() {
  std::vector<std::string> words{"repaired", kNotVerified};
  for (std::size_t k = 0; k < enum_count<Status>(); ++k)
    words.emplace_back(name_of(static_cast<Status>(k)));
  for (std::size_t k = 1; k < enum_count<Reason>(); ++k)
    words.emplace_back(name_of(static_cast<Reason>(k)));
  return words;
}

void check_selection(const RowSelection& choice) {
  if (choice.sort_key.empty() || choice.sort_key == "name" ||
      figure_index(choice.sort_key) < kPlanFigureCount)
    return;
  const std::vector<std::string> keys = sort_keys();
  throw InputError(fmt::format("--sort: '{}' is not one of {}{}", choice.sort_key,
                               fmt::join(keys, ", "),
                               config::spelling_hint(choice.sort_key, keys)));
}

std::string unknown_filter(const RowSelection& choice, const std::vector<std::string>& plan_names) {
  const std::vector<std::string> words = filter_words();
  for (const std::string& word : choice.filters) {
    const bool is_known = std::ranges::find(words, word) != words.end() ||
                          std::ranges::any_of(plan_names, [&](const std::string& name) {
                            return report::plan_matches(name, word);
                          });
    if (is_known) continue;
    std::vector<std::string> candidates = words;
    for (const std::string& name : plan_names) {
      candidates.push_back(name);
      candidates.push_back(demonstration_of(name));
    }
    return fmt::format("no plan has the status, reason or name '{}'{}", word,
                       config::spelling_hint(word, candidates));
  }
  return "";
}

void check_filters(const RowSelection& choice, const std::vector<std::string>& plan_names) {
  const std::string unknown = unknown_filter(choice, plan_names);
  if (!unknown.empty()) throw InputError("--only: " + unknown);
}

bool is_selected(const RowSelection& choice, const PlanRow& row) {
  return std::ranges::all_of(choice.filters, [&](const std::string& word) {
    return word == row.status || (word == name_of(Status::executable) && row.executable()) ||
           (!row.reason.empty() && word == row.reason) || report::plan_matches(row.name, word);
  });
}

void sort_rows(const RowSelection& choice, std::vector<PlanRow>& rows) {
  if (choice.sort_key.empty()) return;
  if (choice.sort_key == "name") {
    std::ranges::stable_sort(rows, {}, &PlanRow::name);
    return;
  }
  const int k = figure_index(choice.sort_key);
  std::ranges::stable_sort(rows, std::ranges::greater{}, [&](const PlanRow& row) {
    return std::isnan(row.figures[k]) ? -kInfinity : plan_figures()[k].worse_sign * row.figures[k];
  });
}

std::string plan_table(const std::vector<PlanRow>& rows, std::size_t width) {
  TextTable table;
  table.columns = {{"plan", "", true, 0}, {"status", "", true, 0}};
  for (const FigureColumn& column : kColumns)
    table.columns.push_back({column.top, column.subhead, false, column.drop_priority});
  for (const PlanRow& row : rows) {
    TextTable::Row& printed =
        table.rows.emplace_back(TextTable::Row{{row.name, row.status}, row.lines});
    for (const FigureColumn& column : kColumns) {
      const int k = figure_index(column.key);
      printed.cells.push_back(format_figure(plan_figures()[k], row.figures[k], row.arm_estimated));
    }
  }
  return table_text(table, width);
}

}  // namespace morphe::commands
