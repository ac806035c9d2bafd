#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <filesystem>
#include <memory>
#include <thread>

#include "pipeline/collision/certified.hpp"
#include "pipeline/files/sha256.hpp"
#include "pipeline/motion/version.hpp"
#include "pipeline/run/run_dataset.hpp"
#include "pipeline/run/run_folder.hpp"
#include "pipeline/store/plan_file.hpp"
#include "stages/commands/commands.hpp"
#include "stages/commands/input_file.hpp"
#include "stages/commands/plan_report.hpp"
#include "stages/import/import.hpp"
#include "stages/planning/plan_movement.hpp"
#include "stages/planning/run_config.hpp"

namespace morphe::commands {
namespace {

namespace fs = std::filesystem;

struct RunArguments {
  std::string config, from, dataset, out, shard = "1/1";
  std::vector<std::string> settings;
  int jobs = 0;
  bool fresh = false, explain = false, strict = false, json = false;
};

/// What a shell adds to the number of the signal that ended a program.
constexpr int kStopped = 128;

fs::path dataset_of(const RunArguments& arguments, const planning::LoadedConfig& config) {
  if (!arguments.dataset.empty()) return arguments.dataset;
  if (!arguments.from.empty()) throw InputError("--from: needs --dataset");
  if (!config.dataset.empty()) return config.dataset;
  throw InputError(
      fmt::format("{}: dataset: is missing (and there is no --dataset)", arguments.config));
}

/// The demonstrations.h5 of a run. A manifest of recordings is imported into the run's folder: the
/// plans then belong to a file that lies beside them, and takes its name when they do.
class Dataset {
 public:
  Dataset(const fs::path& named, const fs::path& folder) : file_(named) {
    if (named.extension() != ".yaml") return;
    published_ = folder / "demonstrations.h5";
    file_ = folder / "demonstrations.h5.new";
    imports::ImportRequest request;
    request.paths = {named};
    imports::write_demonstrations(request, file_);
  }
  ~Dataset() {
    std::error_code ignored;
    if (!published_.empty()) fs::remove(file_, ignored);
  }
  Dataset(const Dataset&) = delete;
  Dataset& operator=(const Dataset&) = delete;
  const fs::path& file() const { return file_; }
  void publish() {
    if (!published_.empty()) fs::rename(file_, published_);
    published_.clear();
  }

 private:
  fs::path file_, published_;
};

void print_table(const run::Journal& journal, const planning::LoadedConfig& config,
                 const fs::path& plans, const run::BatchSummary& summary) {
  const RobotTable& robot = config.robot;
  constexpr int kMostRows = 1000;
  if (summary.movements <= kMostRows) {
    fmt::print("{}\n", plan_table_head());
    journal.each_row([](const std::string& rows) { fmt::print("{}\n", rows); });
  }
  const store::PlanReader written(plans);
  if (written.size() > 0) {
    const std::string base = base_sentence(robot, config.options.placement, written.read(0));
    if (!base.empty()) fmt::print("{}\n", base);
  }
  fmt::print("{}\n{}: {}\n", plan_table_foot(robot, summary), plans.string(),
             run::summary_text_for_people(summary));
}

int stopped(const run::RunResult& result, const run::Journal& journal,
            const run::RunFolder& folder) {
  fmt::print(stderr,
             "{}: stopped by {}: {} of {} demonstrations are finished and kept; the same command "
             "goes on from here\n",
             folder.path().string(), result.signal == SIGINT ? "SIGINT" : "SIGTERM",
             result.summary.demonstrations, journal.wanted());
  return kStopped + result.signal;
}

int execute(const RunArguments& arguments) {
  if (arguments.config.empty() == arguments.from.empty())
    throw InputError("run: needs either CONFIG or --from");
  if (!arguments.from.empty() && !arguments.settings.empty())
    throw InputError("--set: does not go with --from");
  const planning::RunConfig config =
      arguments.from.empty()
          ? planning::run_config(planning::load_config(arguments.config, arguments.settings))
          : planning::stored_config(arguments.from);
  const fs::path named = dataset_of(arguments, config.loaded);
  if (!fs::exists(named)) throw InputError(fmt::format("{}: cannot be read", named.string()));

  const std::string software = morphe::software();
  const run::Shard shard = run::parse_shard(arguments.shard);
  run::RunFolder folder(arguments.out, software, shard, arguments.fresh);
  Dataset dataset(named, folder.path());
  const robot::Robot& robot = config.loaded.robot;
  const planning::Planner planner{config.loaded.options, robot};
  run::Progress progress(arguments.json);

  run::RunRequest request;
  request.dataset = dataset.file();
  request.plans = folder.path() / "plans.h5";
  request.identity.software = software;
  request.identity.program = files::sha256_of_file("/proc/self/exe");
  request.identity.scene = config.scene_sha256;
  request.identity.shard = shard;
  request.identity.header = planning::header_of(config.loaded, "");
  request.identity.robot = robot;
  request.config = config.without_paths;
  request.expected_dataset = config.dataset_sha256;
  request.jobs = arguments.jobs > 0
                     ? arguments.jobs
                     : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  request.explain = arguments.explain;
  request.plan = [&](const Demonstration& demonstration) {
    return planning::plan_demonstration(planner, demonstration);
  };
  request.rows = plan_rows;
  request.publish = [&] { dataset.publish(); };
  const run::RunResult result = run::run_dataset(folder.journal(), request, progress);
  folder.keep();
  if (result.signal != 0) return stopped(result, folder.journal(), folder);

  if (arguments.json) {
    fmt::print("{}\n", run::summary_json(result.summary));
  } else {
    print_table(folder.journal(), config.loaded, request.plans, result.summary);
  }
  if (result.summary.failed > 0) return 1;
  return arguments.strict && result.summary.infeasible > 0 ? 1 : 0;
}

}  // namespace

Command run_command(CLI::App& app) {
  const auto arguments = std::make_shared<RunArguments>();
  app.add_option("CONFIG", arguments->config, "Pipeline config (YAML)")->transform(input_file());
  app.add_option("--from", arguments->from,
                 "plans.h5 whose config, robot and scene are used again");
  app.add_option("--out", arguments->out,
                 "Folder for plans.h5; an unfinished run in it is continued")
      ->required();
  app.add_option("--dataset", arguments->dataset,
                 "demonstrations.h5 or manifest of recordings to use instead of the config's")
      ->transform(input_file());
  app.add_option("--jobs", arguments->jobs, "Number of threads (default: one per core)")
      ->check(CLI::PositiveNumber);
  app.add_option("--set", arguments->settings,
                 "KEY=VALUE: change a value of the config, such as map.starts=64")
      ->allow_extra_args(false);
  app.add_option("--shard", arguments->shard,
                 "I/N: plan part I of N of the dataset; slurm: the part of this array task");
  app.add_flag("--fresh", arguments->fresh,
               "Plan everything anew, including what an earlier run in the folder finished");
  app.add_flag("--explain", arguments->explain, "Say for each demonstration why it is planned");
  app.add_flag("--strict", arguments->strict, "Exit 1 if a movement is infeasible");
  app.add_flag("--json", arguments->json, "Print JSON");
  return [arguments] { return execute(*arguments); };
}

}  // namespace morphe::commands
