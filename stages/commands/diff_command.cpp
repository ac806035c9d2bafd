#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "pipeline/run/diff.hpp"
#include "stages/commands/commands.hpp"
#include "stages/commands/plans_file.hpp"

namespace morphe::commands {

Command diff_command(CLI::App& app) {
  struct Arguments {
    std::string first, second;
    bool json = false;
  };
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("A", arguments->first, "plans.h5, or a run's folder")->required();
  app.add_option("B", arguments->second, "The same, to compare it with")->required();
  app.add_flag("--json", arguments->json, "Print JSON");
  return [arguments] {
    const run::DiffReport report =
        run::diff_files(plans_file(arguments->first), plans_file(arguments->second));
    fmt::print("{}", arguments->json ? run::diff_json(report) : run::diff_text(report));
    return report.differences.empty() ? 0 : 1;
  };
}

}  // namespace morphe::commands
