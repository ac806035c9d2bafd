#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <memory>
#include <thread>

#include "pipeline/collision/certified.hpp"
#include "pipeline/config/hash.hpp"
#include "pipeline/run/output_folder.hpp"
#include "pipeline/store/demonstration_file.hpp"
#include "pipeline/store/plan_file.hpp"
#include "stages/commands.hpp"
#include "stages/import/import.hpp"
#include "stages/plan_movement.hpp"
#include "stages/plan_report.hpp"

namespace morphe {
namespace {

namespace fs = std::filesystem;

struct RunArguments {
  std::string config, dataset, out;
  std::vector<std::string> settings;
  int jobs = 0;
  bool strict = false, json = false;
};

fs::path dataset_of(const RunArguments& arguments, const LoadedConfig& config) {
  if (!arguments.dataset.empty()) return arguments.dataset;
  if (!config.dataset.empty()) return config.dataset;
  throw InputError(
      fmt::format("{}: dataset: is missing (and there is no --dataset)", arguments.config));
}

/// A manifest of recordings is imported into the run's folder first: the plans then belong to a
/// demonstrations.h5 that lies beside them.
fs::path as_demonstrations(const fs::path& dataset, const fs::path& folder) {
  if (dataset.extension() != ".yaml") return dataset;
  fs::path file = folder / "demonstrations.h5";
  DemonstrationWriter writer(file);
  ImportRequest request;
  request.paths = {dataset};
  import_recordings(request, [&](Demonstration&& demonstration) { writer.add(demonstration); });
  writer.finish();
  return file;
}

class Progress {
 public:
  Progress(std::size_t total, bool quiet) : total_(total), quiet_(quiet) {}
  void report(const DemonstrationOutcome& outcome) {
    ++done_;
    if (quiet_) return;
    fmt::print(
        stderr, "[{}/{}] {}: {}\n", done_, total_, outcome.demonstration,
        outcome.error.empty() ? fmt::format("{} movements", outcome.plans.size()) : outcome.error);
  }

 private:
  std::size_t total_, done_ = 0;
  bool quiet_;
};

int execute(const RunArguments& arguments) {
  const LoadedConfig config = load_config(arguments.config, arguments.settings);
  const fs::path dataset = dataset_of(arguments, config);
  if (!fs::exists(dataset)) throw InputError(fmt::format("{}: cannot be read", dataset.string()));

  OutputFolder folder(arguments.out);
  const fs::path demonstrations = as_demonstrations(dataset, folder.path());
  const DemonstrationReader reader(demonstrations);
  const PlanFileHeader header{config.effective, sha256(config.effective),
                              sha256_of_file(demonstrations), "morphe " MORPHE_VERSION,
                              config.inputs};
  const fs::path plans = folder.path() / "plans.h5";
  PlanWriter writer(plans, header, config.robot);
  const Planner planner{config.options, config.robot, capsule_reach(config.robot)};
  PlanReport report(config.robot);
  Progress progress(reader.size(), arguments.json);

  Batch batch;
  batch.next = [&, next = std::size_t{0}]() mutable {
    if (next == reader.size()) return std::unique_ptr<Demonstration>();
    return std::make_unique<Demonstration>(reader.read(next++));
  };
  batch.plan = [&](const Demonstration& demonstration) {
    return plan_demonstration(planner, demonstration);
  };
  batch.write = [&](const DemonstrationOutcome& outcome) {
    for (const Plan& plan : outcome.plans) {
      writer.add(plan);
      report.add(plan);
    }
    progress.report(outcome);
  };
  const int jobs =
      arguments.jobs > 0 ? arguments.jobs : static_cast<int>(std::thread::hardware_concurrency());
  const BatchSummary summary = run_batch(batch, std::max(1, jobs));
  writer.finish();
  folder.keep();

  if (arguments.json) {
    fmt::print("{}\n", summary_json(summary));
  } else {
    fmt::print(
        "{}\n{}: {} demonstrations, {} movements: {} executable ({} repaired), {} infeasible",
        report.table(), plans.string(), summary.demonstrations, summary.movements,
        summary.executable, summary.repaired, summary.infeasible);
    fmt::print("{}\n", summary.failed ? fmt::format(", {} failed", summary.failed) : "");
  }
  if (summary.failed > 0) return 1;
  return arguments.strict && summary.infeasible > 0 ? 1 : 0;
}

}  // namespace

Command run_command(CLI::App& app) {
  const auto arguments = std::make_shared<RunArguments>();
  app.add_option("CONFIG", arguments->config, "Pipeline config (YAML)")->required();
  app.add_option("--out", arguments->out, "Folder for plans.h5")->required();
  app.add_option("--dataset", arguments->dataset,
                 "demonstrations.h5 or a recordings manifest, instead of the config's");
  app.add_option("--jobs", arguments->jobs, "Threads (default: one per core)")
      ->check(CLI::PositiveNumber);
  app.add_option("--set", arguments->settings, "a.b=value: replaces a value of the config")
      ->allow_extra_args(false);
  app.add_flag("--strict", arguments->strict, "Exit 1 if a movement is infeasible");
  app.add_flag("--json", arguments->json, "Print JSON");
  return [arguments] { return execute(*arguments); };
}

}  // namespace morphe
