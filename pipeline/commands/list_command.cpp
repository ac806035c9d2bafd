#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/motion/count_with_noun.hpp"
#include "core/store/plan_file.hpp"
#include "pipeline/commands/branch_text.hpp"
#include "pipeline/commands/certificate_box.hpp"
#include "pipeline/commands/certificate_json.hpp"
#include "pipeline/commands/commands.hpp"
#include "pipeline/commands/plans_file.hpp"
#include "pipeline/commands/reference_frames_table.hpp"
#include "pipeline/commands/shared_options.hpp"
#include "pipeline/commands/text_table.hpp"
#include "pipeline/commands/verdict.hpp"

namespace morphe::commands {
namespace {

std::string list_json(const PlanFileHeader& header, const std::vector<PlanRow>& rows,
                      const std::string& not_verified) {
  nlohmann::ordered_json json{{"not_verified", not_verified},
                              {"assumptions", assumptions_json(header.assumptions)},
                              {"plans", nlohmann::ordered_json::array()}};
  for (const PlanRow& row : rows) {
    nlohmann::ordered_json figures;
    for (int k = 0; k < kPlanFigureCount; ++k) figures[plan_figures()[k].key] = row.figures[k];
    json["plans"].push_back({{"plan", row.name},
                             {"status", row.status},
                             {"reason", row.reason},
                             {"figures", figures},
                             {"clearances", clearances_json(row.clearances)},
                             {"assumptions", assumptions_json(row.assumptions)},
                             {"notes", row.lines}});
  }
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

CommandAction add_list_arguments(CLI::App& app) {
  struct Arguments {
    std::string file;
    RowSelection choice;
    bool json = false, unverified = false;
  };
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("FILE", arguments->file, "plans.h5 or the folder of a run")->required();
  add_row_options(app, arguments->choice);
  add_unverified_option(app, arguments->unverified, "print what the file says of them");
  app.add_flag("--json", arguments->json, "Print JSON");
  return [arguments] {
    check_selection(arguments->choice);
    const std::filesystem::path file = find_plans_file(arguments->file);
    const store::PlanReader plans(file);
    check_filters(arguments->choice, plans.plan_paths());
    const Verdict verdict = arguments->unverified ? Verdict() : verdict_on(file, threads_of(0));
    const std::string not_verified = arguments->unverified ? kNotJudged : verdict.text();
    const robot::Robot robot(plans.robot());
    const explain::AdviceContext context = explain::advice_context(plans.header().config);
    std::vector<PlanRow> rows;
    std::map<std::string, int> all_branches;
    for (std::size_t k = 0; k < plans.size(); ++k) {
      PlanRow row = row_of(robot, plans.read(k), context);
      distrust(row, verdict.violation_of(row.name));
      if (row.branch.number) ++all_branches[branch_phrase(row.branch)];
      if (is_selected(arguments->choice, row)) rows.push_back(std::move(row));
    }
    sort_rows(arguments->choice, rows);
    if (arguments->json) {
      fmt::print("{}\n", list_json(plans.header(), rows, not_verified));
      return 0;
    }
    note_other_branches(all_branches, rows);
    CertificateBox box;
    for (const PlanRow& row : rows) box.add(row);
    const std::size_t width = terminal_width();
    std::map<std::string, int> branches;
    for (const PlanRow& row : rows)
      if (row.branch.number) ++branches[branch_phrase(row.branch)];
    if (!not_verified.empty())
      fmt::print("{}", wrap_line(fmt::format("{}: {}", file.string(), not_verified), width, ""));
    fmt::print("{}{}{}{}{} of {}\n", plan_table(rows, width),
               reference_frames_text(plans.robot().name, rows, width),
               branches_text(plans.robot().name, branches, rows, width),
               box.text(plans.header().assumptions, width), rows.size(),
               count_with_noun(plans.size(), "plan"));
    return 0;
  };
}

}  // namespace

Command list_command() {
  return {"list", "Print the table of plans in a plans.h5, sorted or filtered",
          "  morphe list outputs/first --sort tip_error_max --only executable\n",
          add_list_arguments};
}

}  // namespace morphe::commands
