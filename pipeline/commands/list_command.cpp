#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "core/store/plan_file.hpp"
#include "pipeline/commands/commands.hpp"
#include "pipeline/commands/plans_file.hpp"
#include "pipeline/commands/reference_frames_table.hpp"
#include "pipeline/commands/row_options.hpp"
#include "pipeline/commands/text_table.hpp"

namespace morphe::commands {

Command list_command(CLI::App& app) {
  struct Arguments {
    std::string file;
    RowSelection choice;
  };
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("FILE", arguments->file, "plans.h5 or the folder of a run")->required();
  add_row_options(app, arguments->choice);
  return [arguments] {
    check_selection(arguments->choice);
    const store::PlanReader plans(find_plans_file(arguments->file));
    const robot::Robot robot(plans.robot());
    std::vector<PlanRow> rows;
    for (std::size_t k = 0; k < plans.size(); ++k) {
      PlanRow row = row_of(robot, plans.read(k));
      if (is_selected(arguments->choice, row)) rows.push_back(std::move(row));
    }
    const std::size_t shown = rows.size(), width = terminal_width();
    sort_rows(arguments->choice, rows);
    fmt::print("{}{}{} of {} plan{}\n", plan_table(rows, width),
               reference_frames_text(plans.robot().name, rows, width), shown, plans.size(),
               plans.size() == 1 ? "" : "s");
    return 0;
  };
}

}  // namespace morphe::commands
