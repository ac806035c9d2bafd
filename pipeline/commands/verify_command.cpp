#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "pipeline/commands/commands.hpp"
#include "pipeline/commands/plans_file.hpp"
#include "pipeline/commands/shared_options.hpp"
#include "pipeline/planning/plan_requirements.hpp"
#include "stages/verify/verify.hpp"

namespace morphe::commands {
namespace {

CommandAction add_verify_arguments(CLI::App& app) {
  struct Arguments {
    std::string file;
    int jobs = 0;
    bool json = false;
  };
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("FILE", arguments->file, "plans.h5 or the folder of a run")->required();
  add_jobs_option(app, arguments->jobs);
  app.add_flag("--json", arguments->json, "Print JSON");
  return [arguments] {
    const verify::VerifyReport report = verify::verify_file(
        find_plans_file(arguments->file), planning::plan_requirements, threads_of(arguments->jobs));
    fmt::print("{}",
               arguments->json ? verify::verify_json(report) + "\n" : verify::verify_text(report));
    return report.violations.empty() ? 0 : 1;
  };
}

}  // namespace

Command verify_command() {
  return {"verify", "Check a plans.h5 with independent code, using only the file",
          "  morphe verify outputs/first\n", add_verify_arguments};
}

}  // namespace morphe::commands
