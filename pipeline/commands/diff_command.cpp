#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

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
    bool json = false, all = false;
  };
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("A", arguments->first, "plans.h5 or the folder of a run")->required();
  app.add_option("B", arguments->second, "The plans.h5 or run folder to compare with it")
      ->required();
  app.add_flag("--all", arguments->all,
               "List every dataset that differs, with the largest change and its place");
  add_row_options(app, arguments->choice);
  app.add_flag("--json", arguments->json, "Print JSON (complete)");
  return [arguments] {
    check_selection(arguments->choice);
    expect_effect(!arguments->json || !arguments->all, "--all", "with --json, which lists all");
    expect_printed_rows(arguments->choice, arguments->json, false);
    const PlanDiff diff =
        compare_plans(find_plans_file(arguments->first), find_plans_file(arguments->second));
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
