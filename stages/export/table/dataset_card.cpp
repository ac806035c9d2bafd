#include "stages/export/table/dataset_card.hpp"

#include <fmt/format.h>

#include "core/config/node.hpp"
#include "core/files/printable.hpp"
#include "core/motion/assumption_text.hpp"
#include "core/motion/count_with_noun.hpp"
#include "core/motion/input_error.hpp"
#include "stages/export/table/plan_columns.hpp"

namespace morphe::exports {
namespace {

std::string stated(const std::string& text) {
  return text.empty() ? "not stated" : markdown_cell(text);
}

/// Returns the seed of a config, as it is written there.
std::string seed_of(const std::string& config) {
  try {
    const config::ConfigNode root = config::ConfigNode::parse(config, "config");
    return root.is_map() && root.has("seed") ? root["seed"].text() : "";
  } catch (const InputError&) {
    return "";  // the text is a stranger's, or of another version
  }
}

std::string yield_text(const PlanCounts& counts) {
  std::string text =
      fmt::format("\n## Yield\n{} planned: ", count_with_noun(counts.plans, "movement"));
  bool is_first = true;
  for (const auto& [status, plans] : counts.statuses) {
    text += fmt::format("{}{} {} ({:.1f} %)", is_first ? "" : ", ", plans, status,
                        100.0 * plans / counts.plans);
    is_first = false;
  }
  text += ".\n";
  if (!counts.reasons.empty()) {
    text += "\n| reason of plans that are infeasible or partial | plans |\n|---|---|\n";
    for (const auto& [reason, plans] : counts.reasons)
      text += fmt::format("| `{}` | {} |\n", reason, plans);
  }
  return text;
}

std::string sources_text(const PlanCounts& counts) {
  std::string text =
      "\n## Sources and licences\nOf the recordings, as they state them. A licence binds what is "
      "made from a recording, too.\n\n| source | licence | plans |\n|---|---|---|\n";
  for (const auto& [source, plans] : counts.sources)
    text += fmt::format("| {} | {} | {} |\n", stated(source.first), stated(source.second), plans);
  text += "\n| person | plans |\n|---|---|\n";
  for (const auto& [subject, plans] : counts.subjects)
    text += fmt::format("| {} | {} |\n", stated(subject), plans);
  return text;
}

std::string split_text(const PlanCounts& counts, const SplitOptions& split) {
  if (split.by == SplitBy::none) return "";
  std::string text = fmt::format(
      "\n## Split\nBy {}: all plans of one {} are on one side, which the hash of its name decides, "
      "the same in every file and for every robot. About {:g} % are for validation.\n\n"
      "| side | plans |\n|---|---|\n",
      name_of(split.by), name_of(split.by), 100 * split.validation_share);
  for (const auto& [side, plans] : counts.sides) text += fmt::format("| {} | {} |\n", side, plans);
  return text;
}

std::string origin_text(const CardOptions& options, const PlanFileHeader& header,
                        const RobotModel& robot) {
  const std::string seed = seed_of(header.config);
  std::string text = fmt::format(
      "\n## Made from\n| | |\n|---|---|\n| robot | {} |\n| software | {} |\n| seed of the config | "
      "{} |\n| SHA-256 of the config | `{}` |\n| SHA-256 of the recordings | `{}` |\n"
      "| verified | {} |\n",
      markdown_cell(robot.name), stated(header.software), stated(seed),
      markdown_cell(header.config_sha256), markdown_cell(header.dataset_sha256),
      options.not_verified.empty() ? "yes, every plan, by `morphe verify`"
                                   : "**no**: " + markdown_cell(options.not_verified));
  if (!options.where.empty())
    text += fmt::format("| only plans with | {} |\n", markdown_cell(options.where));
  if (header.assumptions.empty()) return text;
  text += "\n## Assumed\nFor all plans; those of single plans are in the table.\n\n";
  for (const Assumption& each : header.assumptions)
    text += fmt::format("- {}: {}\n", name_of(each.kind), markdown_cell(phrase(each)));
  return text;
}

}  // namespace

void PlanCounts::add(const Plan& plan) {
  ++plans;
  ++statuses[std::string(name_of(plan.status()))];
  if (plan.reason != Reason::none) ++reasons[std::string(name_of(plan.reason))];
}

void PlanCounts::add_chosen(const Plan& plan, std::string_view side) {
  ++chosen;
  ++sources[{plan.source, plan.licence}];
  ++subjects[plan.subject];
  ++sides[std::string(side)];
}

std::string markdown_cell(std::string_view text) {
  std::string cell;
  for (const char c : files::make_printable(text)) {
    if (std::string_view("|<>[]*_`").find(c) != std::string_view::npos) cell += '\\';
    cell += c;
  }
  return cell;
}

std::string columns_markdown() {
  std::string text = "| column | unit | meaning |\n|---|---|---|\n";
  for (const PlanColumn& column : plan_columns())
    text += fmt::format("| `{}` | {} | {} |\n", column.name, column.unit,
                        markdown_cell(column.meaning));
  return text;
}

std::string dataset_card(const PlanCounts& counts, const CardOptions& options,
                         const PlanFileHeader& header, const RobotModel& robot) {
  return fmt::format("{}# {}\n{}{}{}{}{}", options.front_matter, markdown_cell(options.title),
                     options.content, yield_text(counts), sources_text(counts),
                     split_text(counts, options.split), origin_text(options, header, robot));
}

}  // namespace morphe::exports
