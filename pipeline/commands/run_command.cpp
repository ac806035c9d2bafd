#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "core/files/sha256.hpp"
#include "core/motion/count_with_noun.hpp"
#include "core/motion/version.hpp"
#include "pipeline/commands/assumptions.hpp"
#include "pipeline/commands/branch_text.hpp"
#include "pipeline/commands/certificate_box.hpp"
#include "pipeline/commands/commands.hpp"
#include "pipeline/commands/import_summary.hpp"
#include "pipeline/commands/reference_frames_table.hpp"
#include "pipeline/commands/robots_table.hpp"
#include "pipeline/commands/run_dataset_file.hpp"
#include "pipeline/commands/shared_options.hpp"
#include "pipeline/commands/text_table.hpp"
#include "pipeline/commands/verdict.hpp"
#include "pipeline/planning/plan_movement.hpp"
#include "pipeline/planning/run_config.hpp"
#include "pipeline/planning/verified_plan.hpp"
#include "pipeline/report/report.hpp"
#include "pipeline/run/output_files.hpp"
#include "pipeline/run/output_folder.hpp"
#include "pipeline/run/run_dataset.hpp"
#include "pipeline/run/run_folder.hpp"
#include "stages/import/import.hpp"

namespace morphe::commands {
namespace {

namespace fs = std::filesystem;

struct RunArguments {
  std::string config, from, out, shard = "1/1";
  std::vector<std::string> datasets, settings;
  imports::ImportRequest recordings;  ///< options for recordings that are imported
  int jobs = 0;
  bool fresh = false, explain = false, strict = false, json = false, report = false;
  bool quiet = false, verbose = false;
  RowSelection choice;
};

/// The offset that a shell adds to the number of the signal that ended a program.
constexpr int kSignalExitOffset = 128;

run::Verbosity verbosity_of(const RunArguments& arguments) {
  if (arguments.verbose) return run::Verbosity::verbose;
  return arguments.json || arguments.quiet ? run::Verbosity::quiet : run::Verbosity::normal;
}

/// Returns the dataset of a run, which is the same for all robots.
std::vector<fs::path> dataset_of(const RunArguments& arguments,
                                 const planning::LoadedConfig& config) {
  if (!arguments.datasets.empty()) return {arguments.datasets.begin(), arguments.datasets.end()};
  if (!arguments.from.empty()) throw InputError("--from: needs --dataset");
  if (!config.dataset.empty()) return {config.dataset};
  throw InputError(
      fmt::format("{}: dataset: is missing (give it here, or --dataset)", arguments.config));
}

/// The run of one robot. For a config without `robots`, the name is "" and the folder is --out.
struct RobotRun {
  std::string name;
  planning::RunConfig config;
  std::unique_ptr<run::RunFolder> folder;
  run::BatchSummary summary;

  fs::path plans() const { return folder->path() / "plans.h5"; }
};

/// Opens the folder of each robot; of several, the folder that contains them is `common`.
std::vector<RobotRun> runs_of(const RunArguments& arguments, const std::string& software,
                              const run::Shard& shard, std::optional<run::OutputFolder>& common) {
  std::vector<RobotRun> runs;
  if (!arguments.from.empty()) {
    runs.push_back({"", planning::stored_config(arguments.from), nullptr, {}});
  } else {
    for (planning::RobotConfig& robot : planning::load_robots(arguments.config, arguments.settings))
      runs.push_back({robot.name, planning::run_config(std::move(robot.loaded)), nullptr, {}});
  }
  for (const fs::path& named : dataset_of(arguments, runs.front().config.loaded))
    expect_exists(named);
  if (!runs.front().name.empty()) common.emplace(arguments.out);
  for (RobotRun& one : runs) {
    const fs::path folder =
        one.name.empty() ? fs::path(arguments.out) : arguments.out / fs::path(one.name);
    one.folder = std::make_unique<run::RunFolder>(folder, software, shard, arguments.fresh);
  }
  return runs;
}

/// Returns how the base stands, as the end of a sentence; "" for a hand without an arm.
std::string base_words(const robot::Robot& robot, const map::PlacementOptions& placement) {
  const std::string words = map::standing_text(robot, placement);
  return words.empty() ? "" : ": the base " + words;
}

CertificateBox certificate_box(const RobotRun& one) {
  CertificateBox box;
  one.folder->journal().each_row([&](const std::string& text) { box.add(row_from_json(text)); });
  return box;
}

/// Prints the summary and, unless --quiet is given, the plans (of more than kMaxPrintedRows only
/// filtered or sorted ones), the positions of the reference frames, and remarks.
void print_table(const RunArguments& arguments, const RobotRun& one) {
  const robot::Robot& robot = one.config.loaded.robot;
  constexpr int kMaxPrintedRows = 1000;
  if (arguments.quiet) {
    fmt::print("{}: {}\n", one.plans().string(), run::summary_sentence(one.summary));
    return;
  }
  const RowSelection& choice = arguments.choice;
  std::vector<PlanRow> named;
  if (one.summary.movements <= kMaxPrintedRows || !choice.sort_key.empty() ||
      !choice.filters.empty()) {
    std::vector<PlanRow> rows;
    std::vector<std::string> names;
    one.folder->journal().each_row([&](const std::string& text) {
      PlanRow row = row_from_json(text);
      names.push_back(row.name);
      if (is_selected(choice, row)) rows.push_back(std::move(row));
    });
    sort_rows(choice, rows);
    note_other_branches(one.summary.branches, rows);
    const std::size_t width = terminal_width();
    fmt::print("{}{}", plan_table(rows, width), reference_frames_text(robot.name, rows, width));
    if (const std::string unknown = unknown_filter(choice, names); !unknown.empty())
      fmt::print("note: --only: {}\n", unknown);
    if (!choice.filters.empty())
      fmt::print("shown: {} of {} plans\n", rows.size(), one.summary.movements);
    named = std::move(rows);
  }
  fmt::print("{}: {} of {} fingertip goals are out of reach with this placement{}\n", robot.name,
             one.summary.out_of_reach, one.summary.goals,
             base_words(robot, one.config.loaded.options.placement));
  if (const std::string unchecked = unchecked_sentence(robot.unchecked_links); !unchecked.empty())
    fmt::print("{}: {}\n", robot.name, unchecked);
  fmt::print("{}", branches_text(robot.name, one.summary.branches, named, terminal_width()));
  fmt::print("{}", certificate_box(one).text(one.config.loaded.assumptions, terminal_width()));
  if (const std::string speed = run::speed_text(one.summary); !speed.empty())
    fmt::print("{}\n", speed);
  fmt::print("{}: {}\n", one.plans().string(), run::summary_sentence(one.summary));
}

int report_stop(const RobotRun& one, int signal) {
  fmt::print(
      stderr,
      "{}: stopped by {}: {} of {} finished and kept; run the same command again to continue\n",
      one.folder->path().string(), signal == SIGINT ? "SIGINT" : "SIGTERM",
      one.summary.demonstrations,
      count_with_noun(one.folder->journal().scheduled_count(), "demonstration"));
  return kSignalExitOffset + signal;
}

/// Plans all demonstrations for one robot and sets its summary. Returns the stopping signal, or 0.
int plan_all(const RunArguments& arguments, const run::Shard& shard, RunDatasetFile& dataset,
             RobotRun& one) {
  const robot::Robot& robot = one.config.loaded.robot;
  const planning::PlanRequirements requirements = planning::requirements_of(one.config.loaded);
  const planning::PlanningInputs planner{one.config.loaded.options, robot, nullptr, &requirements};
  run::RunRequest request;
  request.dataset = dataset.file();
  request.plans = one.plans();
  request.identity.software = morphe::software();
  request.identity.program = files::sha256_of_file("/proc/self/exe");
  request.identity.scene = one.config.scene_sha256;
  request.identity.shard = shard;
  request.identity.header = planning::header_of(one.config.loaded, "");
  request.identity.robot = robot;
  request.config = one.config.without_paths;
  request.expected_dataset = one.config.dataset_sha256;
  request.dataset_key = dataset.key();
  request.jobs = threads_of(arguments.jobs);
  request.explain = arguments.explain || arguments.verbose;
  request.plan = [&](const Demonstration& demonstration) {
    return planning::plan_demonstration(planner, demonstration);
  };
  const explain::AdviceContext context = explain::advice_context(planner.config);
  request.rows = [&](const Plan& plan) { return row_to_json(row_of(robot, plan, context)); };
  request.publish = [&] { dataset.publish(); };
  run::Progress progress(verbosity_of(arguments));
  const run::RunResult result = run::run_dataset(one.folder->journal(), request, progress);
  one.folder->keep();
  one.summary = result.summary;
  one.summary.demonstrations += dataset.failed();
  one.summary.failed += dataset.failed();
  return result.signal;
}

void print_results(const RunArguments& arguments, const std::vector<RobotRun>& runs) {
  const bool several = !runs.front().name.empty();
  if (arguments.json) {
    nlohmann::ordered_json all;
    for (const RobotRun& one : runs) {
      const std::string summary = run::summary_json(one.summary);
      if (!several) fmt::print("{}\n", summary);
      all["robots"][one.name] = nlohmann::ordered_json::parse(summary);
    }
    if (several) fmt::print("{}\n", all.dump());
    return;
  }
  std::vector<std::pair<std::string, fs::path>> robots;
  for (const RobotRun& one : runs) {
    if (several) fmt::print("{}\n", one.name);
    print_table(arguments, one);
    if (several) {
      fmt::print("\n");
      robots.emplace_back(one.name, one.plans());
    }
  }
  if (several) fmt::print("{}", robots_table(robots, terminal_width()));
}

/// Writes DIR/report.html with the plans of all robots side by side.
void write_page(const RunArguments& arguments, const std::vector<RobotRun>& runs) {
  report::ReportRequest request;
  request.jobs = threads_of(arguments.jobs);
  for (const RobotRun& one : runs) {
    request.runs.push_back({one.plans(), one.name.empty() ? one.config.loaded.robot.name : one.name,
                            verdict_on(one.plans(), request.jobs).text()});
  }
  const fs::path page = fs::path(arguments.out) / "report.html";
  const run::OutputFiles lock({page});
  report::write_report(request, page);
  if (!arguments.json && !arguments.quiet) fmt::print("{}: open it in a browser\n", page.string());
}

int execute(const RunArguments& arguments) {
  if (arguments.config.empty() == arguments.from.empty())
    throw InputError("run: needs either CONFIG or --from");
  if (!arguments.from.empty() && !arguments.settings.empty())
    throw InputError("--set: cannot be combined with --from");
  check_selection(arguments.choice);
  expect_printed_rows(arguments.choice, arguments.json, arguments.quiet);
  const std::string software = morphe::software();
  const run::Shard shard = run::parse_shard(arguments.shard);
  std::optional<run::OutputFolder> common;
  std::vector<RobotRun> runs = runs_of(arguments, software, shard, common);
  imports::ImportRequest recordings = arguments.recordings;
  recordings.paths = dataset_of(arguments, runs.front().config.loaded);
  RunDatasetFile dataset(std::move(recordings), arguments.out, arguments.fresh);
  for (const RobotRun& one : runs) one.folder->expect_own_plans();
  for (RobotRun& one : runs) {
    const int signal = plan_all(arguments, shard, dataset, one);
    if (signal == 0) continue;
    dataset.keep();
    return report_stop(one, signal);
  }
  print_results(arguments, runs);
  if (arguments.report) write_page(arguments, runs);
  const auto any = [&](int run::BatchSummary::*count) {
    return std::ranges::any_of(runs, [&](const RobotRun& one) { return one.summary.*count > 0; });
  };
  const bool any_rejected = std::ranges::any_of(runs, [](const RobotRun& one) {
    return one.summary.reasons.contains(std::string(name_of(Reason::rejected)));
  });
  if (any(&run::BatchSummary::failed) || any_rejected) return 1;
  const bool all_executable = !any(&run::BatchSummary::infeasible) &&
                              !any(&run::BatchSummary::approximate) &&
                              !any(&run::BatchSummary::partial);
  return arguments.strict && !all_executable ? 1 : 0;
}

CommandAction add_run_arguments(CLI::App& app) {
  const auto arguments = std::make_shared<RunArguments>();
  add_input_option(app, "CONFIG", arguments->config, "Pipeline config (YAML)");
  app.add_option("--from", arguments->from, "plans.h5 whose config, robot and scene are used");
  app.add_option("--out", arguments->out,
                 "Folder for plans.h5; an unfinished run in it is continued")
      ->required();
  add_input_option(
      app, "--dataset", arguments->datasets,
      "Folder of recordings, recording, manifest or demonstrations.h5 to use instead of "
      "the config's; may be repeated")
      ->allow_extra_args(false);
  add_import_options(app, arguments->recordings);
  add_jobs_option(app, arguments->jobs);
  app.add_option("--set", arguments->settings,
                 "Change a value of the config, such as map.starts=64")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  app.add_option("--shard", arguments->shard,
                 "I/N: plan part I of N of the dataset; slurm: the part of this job-array task");
  app.add_flag(
      "--fresh", arguments->fresh,
      "Plan everything again, including demonstrations that an earlier run in the folder finished");
  app.add_flag("--quiet", arguments->quiet, "Print only the summary: no progress, no table");
  app.add_flag(
         "--verbose", arguments->verbose,
         "Print one line per demonstration, also on a terminal, with the reason why it is planned")
      ->excludes("--quiet");
  app.add_flag("--explain", arguments->explain, "Print for each demonstration why it is planned");
  app.add_flag("--report", arguments->report,
               "Also write DIR/report.html, a page that plays every plan");
  add_row_options(app, arguments->choice);
  app.add_flag("--strict", arguments->strict, "Exit 1 unless every movement is executable");
  app.add_flag("--json", arguments->json, "Print JSON");
  return [arguments] { return execute(*arguments); };
}

}  // namespace

Command run_command() {
  return {"run", "Plan recorded demonstrations: write DIR/plans.h5",
          "  morphe run configs/pipelines/pa10_dlr_hit2.yaml --out outputs/first --report\n"
          "  morphe run --from outputs/first/plans.h5 --dataset outputs/first/demonstrations.h5 "
          "--out outputs/again\n",
          add_run_arguments};
}

}  // namespace morphe::commands
