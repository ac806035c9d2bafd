#include "pipeline/commands/row_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

namespace morphe::commands {

void add_row_options(CLI::App& app, RowSelection& choice) {
  std::string keys = "name";
  for (const PlanFigure& figure : plan_figures()) keys += fmt::format(", {}", figure.key);
  app.add_option("--sort", choice.sort_key, "The worst rows first: " + keys)->type_name("KEY");
  app.add_option("--only", choice.filters,
                 "Only plans with this status (executable, repaired, approximate, infeasible), "
                 "reason or name (with * and ?); if repeated, all must match")
      ->type_name("WHAT")
      ->allow_extra_args(false);
}

}  // namespace morphe::commands
