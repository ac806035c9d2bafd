#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "pipeline/commands/commands.hpp"
#include "pipeline/commands/shared_options.hpp"
#include "pipeline/run/output_folder.hpp"
#include "pipeline/study/results.hpp"

namespace morphe::commands {
namespace {

CommandAction add_study_arguments(CLI::App& app) {
  struct Arguments {
    std::string config, out;
    bool quick = false, quiet = false;
    int jobs = 0;
  };
  const auto arguments = std::make_shared<Arguments>();
  add_input_option(app, "CONFIG", arguments->config, "Study (YAML, configs/studies)")->required();
  app.add_option("--out", arguments->out, "Folder for the results")->required();
  app.add_flag("--quick", arguments->quick, "Run the small version");
  app.add_flag("--quiet", arguments->quiet, "Print no progress");
  add_jobs_option(app, arguments->jobs);
  return [arguments] {
    run::OutputFolder folder(arguments->out);
    study::StudyRun run;
    run.config = arguments->config;
    run.folder = folder.path();
    run.quick = arguments->quick;
    run.jobs = threads_of(arguments->jobs);
    run.progress = [quiet = arguments->quiet](const std::string& line) {
      if (!quiet) fmt::print(stderr, "{}\n", line);
    };
    const study::StudyResult result = study::run_study(run);
    study::write_results(result, folder.path());
    folder.keep();
    fmt::print("{}", study::results_table(result));
    return 0;
  };
}

}  // namespace

Command study_command() {
  return {"study", "Run a study: write its figures to DIR/results.json",
          "  morphe study configs/studies/retime.yaml --out outputs/retime --quick\n",
          add_study_arguments};
}

}  // namespace morphe::commands
