#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "core/motion/count_with_noun.hpp"
#include "core/store/demonstration_file.hpp"
#include "core/store/sandbox_probe.hpp"
#include "pipeline/commands/commands.hpp"
#include "pipeline/commands/import_summary.hpp"
#include "pipeline/commands/inspect_report.hpp"
#include "pipeline/commands/shared_options.hpp"
#include "pipeline/planning/pipeline_config.hpp"

namespace morphe::commands {
namespace {

InspectOptions options_of(const std::string& config) {
  if (config.empty()) return {};
  const planning::PipelineConfig options = planning::load_config(config).options;
  return {options.reconstruct, options.human, options.segment, options.audit};
}

bool is_one_recording(const std::vector<std::filesystem::path>& paths) {
  const auto extension = paths.front().extension();
  return paths.size() == 1 && extension != ".h5" && extension != ".yaml" && extension != ".yml" &&
         !std::filesystem::is_directory(paths.front());
}

using Sink = std::function<void(Demonstration&&)>;

void read_demonstrations(const std::filesystem::path& file, const Sink& sink) {
  store::probe_in_sandbox(file);
  const store::DemonstrationReader reader(file);
  for (std::size_t i = 0; i < reader.size(); ++i) sink(reader.read(i));
}

/// Passes the demonstrations of each demonstrations.h5 to `sink`, then those of the other paths,
/// which are imported. Returns the result of the import, empty if there is no other path.
imports::ImportResult for_each_demonstration(imports::ImportRequest request, const Sink& sink) {
  const auto is_imported = [](const std::filesystem::path& path) {
    return std::filesystem::is_directory(path) || !is_demonstrations_file(path);
  };
  std::vector<std::filesystem::path>& paths = request.paths;
  const auto first_read = std::stable_partition(paths.begin(), paths.end(), is_imported);
  if (first_read == paths.begin()) expect_no_import_options(request, paths.front());
  for (auto file = first_read; file != paths.end(); ++file) read_demonstrations(*file, sink);
  paths.erase(first_read, paths.end());
  return request.paths.empty() ? imports::ImportResult{}
                               : imports::import_recordings(request, sink);
}

struct InspectArguments {
  std::string config;
  imports::ImportRequest request;
  bool json = false, points = false;
};

int execute(const InspectArguments& arguments) {
  expect_effect(!arguments.points || !arguments.json, "--points", "with --json, which lists them");
  const InspectOptions options = options_of(arguments.config);
  const std::vector<std::filesystem::path>& paths = arguments.request.paths;
  for (const std::filesystem::path& path : paths) expect_exists(path);
  std::vector<Inspection> all;
  const bool points = arguments.points || is_one_recording(paths);
  std::size_t demonstrations = 0, movements = 0, usable = 0;
  const auto show = [&](Demonstration&& demonstration) {
    Inspection inspection = inspect(demonstration, options);
    ++demonstrations;
    movements += inspection.movements.size();
    usable += inspection.count_usable();
    if (arguments.json) {
      all.push_back(std::move(inspection));
      return;
    }
    fmt::print("{}", inspection_text(inspection));
    if (points) fmt::print("{}", imports::summary_text(inspection.survey));
  };
  const imports::ImportResult imported = for_each_demonstration(arguments.request, show);
  if (arguments.json) {
    fmt::print("{}\n", inspections_json(all, imported.skipped));
  } else {
    fmt::print("{}{}: {}, {}, {} of them usable\n", import_summary_text(imported),
               paths.size() == 1 ? paths.front().string() : count_with_noun(paths.size(), "path"),
               count_with_noun(demonstrations, "demonstration"),
               count_with_noun(movements, "movement"), usable);
  }
  return count_failed(imported) > 0 ? 1 : 0;
}

CommandAction add_inspect_arguments(CLI::App& app) {
  const auto arguments = std::make_shared<InspectArguments>();
  add_input_option(app, "PATH", arguments->request.paths,
                   "demonstrations.h5, recordings, folders of recordings or manifests")
      ->required();
  add_input_option(app, "--config", arguments->config,
                   "Pipeline config to reconstruct and segment with (default: default values)");
  add_import_options(app, arguments->request);
  app.add_flag("--points", arguments->points,
               "List markers or joints with the body part assigned to each (always listed for a "
               "single recording)");
  app.add_flag("--json", arguments->json, "Print JSON");
  return [arguments] { return execute(*arguments); };
}

}  // namespace

Command inspect_command() {
  return {"inspect",
          "Show the content of a recording or demonstrations.h5, and what cannot be used",
          "  morphe inspect datasets/ue-adl/ADL001DR2.csv\n"
          "  morphe inspect outputs/adl.h5 --config configs/pipelines/pa10_dlr_hit2.yaml\n",
          add_inspect_arguments};
}

}  // namespace morphe::commands
