#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "pipeline/commands/commands.hpp"
#include "pipeline/commands/plans_file.hpp"
#include "pipeline/commands/shared_options.hpp"
#include "pipeline/commands/verdict.hpp"
#include "pipeline/planning/verify_recordings.hpp"
#include "stages/verify/verify.hpp"

namespace morphe::commands {
namespace {

CommandAction add_verify_arguments(CLI::App& app) {
  struct Arguments {
    std::string file, dataset;
    int jobs = 0;
    bool json = false;
  };
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("FILE", arguments->file, "plans.h5 or the folder of a run")->required();
  app.add_option("--dataset", arguments->dataset,
                 "demonstrations.h5 of the run: compare the plans with their recordings, too");
  add_jobs_option(app, arguments->jobs);
  app.add_flag("--json", arguments->json, "Print JSON");
  return [arguments] {
    const std::filesystem::path plans = find_plans_file(arguments->file);
    if (!arguments->dataset.empty()) expect_exists(arguments->dataset);
    const int jobs = threads_of(arguments->jobs);
    verify::VerifyReport report = verify_and_note(plans, jobs);
    if (!arguments->dataset.empty())
      planning::verify_recordings(plans, arguments->dataset, jobs, report);
    fmt::print("{}",
               arguments->json ? verify::verify_json(report) + "\n" : verify::verify_text(report));
    return report.violations.empty() ? 0 : 1;
  };
}

}  // namespace

Command verify_command() {
  return {"verify", "Check a plans.h5 with independent code, using only the file",
          "  morphe verify outputs/first\n"
          "  morphe verify outputs/first --dataset outputs/first/demonstrations.h5\n",
          add_verify_arguments};
}

}  // namespace morphe::commands
