#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include "core/motion/count_with_noun.hpp"
#include "pipeline/commands/branch_text.hpp"
#include "pipeline/commands/plan_diff.hpp"
#include "pipeline/commands/text_table.hpp"

namespace morphe::commands {
namespace {

/// Formats a change with its sign, "=" if it rounds to zero at the printed digits.
std::string change_text(const PlanFigure& figure, double change) {
  if (std::isnan(change)) return "-";
  const std::string text = fmt::format("{:+.{}f}", figure.print_scale * change, figure.digits);
  return text.find_first_of("123456789") == std::string::npos ? "=" : text;
}

/// Returns true if the printed rows of a pair differ.
bool differs_visibly(const PlanPair& pair) {
  if (!pair.in_both() || pair.status_changed()) return true;
  for (int k = 0; k < kPlanFigureCount; ++k) {
    if (std::isnan(pair.first->figures[k]) != std::isnan(pair.second->figures[k])) return true;
    if (change_text(plan_figures()[k], pair.change(k)).find_first_not_of("-=") != std::string::npos)
      return true;
  }
  return false;
}

std::string outcome(const PlanRow& row) {
  return row.reason.empty() ? row.status : fmt::format("{} ({})", row.status, row.reason);
}

std::set<std::string> differing_plans(const PlanDiff& diff) {
  std::set<std::string> differing;
  for (const run::Difference& difference : diff.dataset_differences.differences)
    if (!difference.plan.empty()) differing.insert(difference.plan);
  return differing;
}

std::string counts_text(const PlanDiff& diff, const std::set<std::string>& differing) {
  int both = 0, only_first = 0, only_second = 0, different = 0;
  for (const PlanPair& pair : diff.pairs) {
    both += pair.in_both() ? 1 : 0;
    only_first += pair.second ? 0 : 1;
    only_second += pair.first ? 0 : 1;
    different += pair.in_both() && differing.contains(pair.name) ? 1 : 0;
  }
  std::string text = fmt::format("A: {}\nB: {}\n", diff.first.string(), diff.second.string());
  if (differing.empty() && only_first + only_second == 0) {
    text += fmt::format("{} in both, all equal; the files differ otherwise:\n",
                        count_with_noun(both, "plan"));
  } else {
    text += fmt::format("{} in both, {} of them differ{}", count_with_noun(both, "plan"), different,
                        different == 1 ? "s" : "");
    if (only_first > 0) text += fmt::format("; {} only in A", only_first);
    if (only_second > 0) text += fmt::format("; {} only in B", only_second);
    text += "\n";
  }
  for (const auto& [file, not_verified] :
       {std::pair("A", &diff.first_not_verified), std::pair("B", &diff.second_not_verified)})
    if (!not_verified->empty()) text += fmt::format("{}: {}\n", file, *not_verified);
  if (!diff.config_changes.empty())
    text += fmt::format("config: {}\n", fmt::join(diff.config_changes, ", "));
  if (!diff.file_changes.empty())
    text += fmt::format("files: {}\n", fmt::join(diff.file_changes, ", "));
  return text;
}

/// Returns the plans whose status changed, in three groups, each below the number of its plans.
std::string status_text(const std::vector<PlanPair>& pairs, std::size_t width) {
  std::string worse, better, other;
  int lost = 0, won = 0, changed = 0;
  for (const PlanPair& pair : pairs) {
    if (!pair.status_changed()) continue;
    const bool was_ok = pair.first->executable(), is_ok = pair.second->executable();
    std::string line =
        fmt::format("  {}: {} -> {}\n", pair.name, outcome(*pair.first), outcome(*pair.second));
    if (was_ok && !is_ok && !pair.second->lines.empty())
      line += wrap_line(pair.second->lines.front(), width, "    ");
    (was_ok && !is_ok ? worse : is_ok && !was_ok ? better : other) += line;
    ++(was_ok && !is_ok ? lost : is_ok && !was_ok ? won : changed);
  }
  std::string text;
  if (lost > 0)
    text += fmt::format("{} no longer executable:\n{}", count_with_noun(lost, "plan"), worse);
  if (won > 0) text += fmt::format("{} executable now:\n{}", count_with_noun(won, "plan"), better);
  if (changed > 0)
    text += count_with_noun(changed, "plan") + " with another change of status:\n" + other;
  return text;
}

/// Returns the plans whose branch changed, each with the change of its palm, which tells how much
/// of the change is another posture of the hand.
std::string branch_lines(const std::vector<PlanPair>& pairs, std::size_t width) {
  std::string lines;
  int changed = 0;
  const PlanFigure& palm = plan_figures()[figure_index("palm_error")];
  for (const PlanPair& pair : pairs) {
    const std::string change =
        pair.in_both() ? branch_change(pair.first->branch, pair.second->branch) : "";
    if (change.empty()) continue;
    ++changed;
    const auto palm_of = [&](const PlanRow& row) {
      return format_figure(palm, row.figures[figure_index("palm_error")]);
    };
    lines += wrap_line(fmt::format("{}: {}; palm {} -> {} degrees", pair.name, change,
                                   palm_of(*pair.first), palm_of(*pair.second)),
                       width, "  ");
  }
  return changed == 0 ? "" : count_with_noun(changed, "plan") + " in another branch:\n" + lines;
}

bool arm_estimated(const PlanPair& pair) {
  return (pair.first && pair.first->arm_estimated) || (pair.second && pair.second->arm_estimated);
}

std::string figures_text(const PlanDiff& diff, std::size_t width) {
  const bool estimate = std::ranges::any_of(diff.pairs, arm_estimated);
  TextTable table;
  table.columns = {{"", "", true, 0},         {"", "", true, 0},
                   {"median", "A", false, 0}, {"", "B", false, 0},
                   {"", "B - A", false, 0},   {"largest", "change", false, 0},
                   {"", "of plan", true, 2},  {"over", "plans", false, 1}};
  for (int k = 0; k < kPlanFigureCount; ++k) {
    const PlanFigure& figure = plan_figures()[k];
    const FigureChange& change = diff.figures[k];
    if (change.plans == 0) continue;
    table.rows.push_back(
        {{std::string(figure.name), std::string(figure.unit),
          format_figure(figure, change.median_first, estimate),
          format_figure(figure, change.median_second, estimate),
          change_text(figure, change.median_second - change.median_first),
          change_text(figure, change.max_change), change.plan, fmt::format("{}", change.plans)},
         {}});
  }
  return table.rows.empty() ? "" : table_text(table, width);
}

/// The columns that are dropped first on a narrow terminal.
constexpr std::array<std::string_view, 3> kOptionalColumns{"mapped_tip_error", "max_joint_step",
                                                           "tip_error_mean"};

/// Returns a table of B - A for each plan.
std::string rows_text(const std::vector<PlanPair>& pairs, std::size_t width) {
  TextTable table;
  table.columns = {{"B - A", "", true, 0}, {"status", "", true, 0}};
  for (const PlanFigure& figure : plan_figures()) {
    const std::string name(figure.name), unit(figure.unit);
    const std::size_t blank = name.find(' ');
    const std::string rest = blank == std::string::npos ? "" : name.substr(blank + 1);
    const std::string gap = rest.empty() || unit.empty() ? "" : " ";
    const bool optional = std::ranges::find(kOptionalColumns, figure.key) != kOptionalColumns.end();
    table.columns.push_back({name.substr(0, blank), rest + gap + unit, false, optional ? 3 : 1});
  }
  int hidden = 0;
  for (const PlanPair& pair : pairs) {
    if (!differs_visibly(pair)) {
      ++hidden;
      continue;
    }
    TextTable::Row& row = table.rows.emplace_back();
    row.cells = {pair.name, !pair.first    ? "only in B"
                            : !pair.second ? "only in A"
                            : pair.status_changed()
                                ? pair.first->status + " -> " + pair.second->status
                                : pair.first->status};
    for (int k = 0; k < kPlanFigureCount; ++k) {
      const PlanFigure& figure = plan_figures()[k];
      const std::string text = change_text(figure, pair.change(k));
      const bool marked = figure.uses_human_arm && text.size() > 1 && arm_estimated(pair);
      row.cells.push_back(marked ? "~" + text : text);
    }
  }
  std::string text = table.rows.empty() ? "" : "\n" + table_text(table, width);
  if (hidden > 0)
    text += count_with_noun(hidden, "plan is", "plans are") + " equal in all these figures\n";
  return text;
}

/// Formats metres as mm and other units as given in the file.
std::string amount_text(const run::Difference& difference) {
  const bool metres = difference.unit == "m";
  const bool has_unit = !difference.unit.empty() && difference.unit != "1";
  const std::string unit = metres ? " mm" : has_unit ? " " + difference.unit : "";
  const double scale = metres ? 1e3 : 1;
  return fmt::format("max change {:.6g}{} ({:.6g} -> {:.6g}){}{}", scale * *difference.max_abs,
                     unit, scale * difference.first, scale * difference.second,
                     difference.location.empty() ? "" : " at ", difference.location);
}

std::string datasets_text(const PlanDiff& diff, const std::vector<PlanPair>& pairs) {
  std::set<std::string> names{""};
  for (const PlanPair& pair : pairs) names.insert(pair.name);
  std::string text = "\n";
  for (const run::Difference& difference : diff.dataset_differences.differences) {
    if (!names.contains(difference.plan)) continue;
    text += difference.plan.empty() ? "the file" : difference.plan;
    if (!difference.dataset.empty()) text += " " + difference.dataset;
    text += ":";
    if (difference.max_abs) text += " " + amount_text(difference);
    if (!difference.change.empty()) text += " " + difference.change;
    text += "\n";
  }
  return text;
}

}  // namespace

std::string diff_text(const PlanDiff& diff, const std::vector<PlanPair>& pairs, bool all,
                      std::size_t width) {
  if (diff.equal()) return fmt::format("equal: {}\n", count_with_noun(diff.pairs.size(), "plan"));
  const std::set<std::string> differing = differing_plans(diff);
  std::string text = counts_text(diff, differing);
  if (!differing.empty())
    text += status_text(diff.pairs, width) + branch_lines(diff.pairs, width) +
            figures_text(diff, width) + rows_text(pairs, width);
  const bool told =
      !(differing.empty() && diff.config_changes.empty() && diff.file_changes.empty());
  return text + (all || !told
                     ? datasets_text(diff, pairs)
                     : "(--all lists every dataset that differs, with the largest change and its "
                       "place)\n");
}

}  // namespace morphe::commands
