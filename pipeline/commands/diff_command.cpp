#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "pipeline/commands/commands.hpp"
#include "pipeline/commands/plan_diff.hpp"
#include "pipeline/commands/plans_file.hpp"
#include "pipeline/commands/shared_options.hpp"
#include "pipeline/commands/text_table.hpp"

namespace morphe::commands {
namespace {

CommandAction add_diff_arguments(CLI::App& app) {
  struct Arguments {
    std::string first, second;
    RowSelection choice;
    bool json = false, all = false, unverified = false;
  };
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("A", arguments->first, "plans.h5 or the folder of a run")->required();
  app.add_option("B", arguments->second, "The plans.h5 or run folder to compare with it")
      ->required();
  app.add_flag("--all", arguments->all,
               "List every dataset that differs, with the largest change and its place");
  add_row_options(app, arguments->choice);
  add_unverified_option(app, arguments->unverified, "compare what the files say of them");
  app.add_flag("--json", arguments->json, "Print JSON (complete)");
  return [arguments] {
    check_selection(arguments->choice);
    expect_effect(!arguments->json || !arguments->all, "--all", "with --json, which lists all");
    expect_printed_rows(arguments->choice, arguments->json, false);
    const PlanDiff diff =
        compare_plans(find_plans_file(arguments->first), find_plans_file(arguments->second),
                      arguments->unverified, threads_of(0));
    std::vector<std::string> names;
    for (const PlanPair& pair : diff.pairs) names.push_back(pair.name);
    check_filters(arguments->choice, names);
    fmt::print("{}", arguments->json ? diff_json(diff)
                                     : diff_text(diff, select_pairs(diff, arguments->choice),
                                                 arguments->all, terminal_width()));
    return diff.equal() ? 0 : 1;
  };
}

}  // namespace

Command diff_command() {
  return {"diff", "Compare two plans.h5: which plans differ, and by how much",
          "  morphe diff outputs/first outputs/again\n", add_diff_arguments};
}

}  // namespace morphe::commands
