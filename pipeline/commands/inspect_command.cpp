#include <fmt/format.h>

#include <CLI/CLI.hpp>
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
  return {options.reconstruct, options.human, options.segment};
}

bool is_one_recording(const std::filesystem::path& file) {
  const auto extension = file.extension();
  return extension != ".h5" && extension != ".yaml" && extension != ".yml" &&
         !std::filesystem::is_directory(file);
}

/// Passes all demonstrations of a demonstrations.h5 to `sink`, or those of recordings, which are
/// imported. Returns the result of the import, empty for a demonstrations.h5.
imports::ImportResult for_each_demonstration(const imports::ImportRequest& request,
                                             const std::function<void(Demonstration&&)>& sink) {
  const std::filesystem::path& file = request.paths.front();
  if (std::filesystem::is_directory(file) || !is_demonstrations_file(file))
    return imports::import_recordings(request, sink);
  store::probe_in_sandbox(file);
  const store::DemonstrationReader reader(file);
  for (std::size_t i = 0; i < reader.size(); ++i) sink(reader.read(i));
  return {};
}

CommandAction add_inspect_arguments(CLI::App& app) {
  struct Arguments {
    std::string file, config;
    imports::ImportRequest request;
    bool json = false, points = false;
  };
  const auto arguments = std::make_shared<Arguments>();
  add_input_option(app, "FILE", arguments->file,
                   "demonstrations.h5, a recording, a folder of recordings or a manifest")
      ->required();
  add_input_option(app, "--config", arguments->config,
                   "Pipeline config to reconstruct and segment with (default: default values)");
  add_import_options(app, arguments->request);
  app.add_flag("--points", arguments->points,
               "List markers or joints with the body part assigned to each (always listed for a "
               "single recording)");
  app.add_flag("--json", arguments->json, "Print JSON");
  return [arguments] {
    const InspectOptions options = options_of(arguments->config);
    arguments->request.paths = {arguments->file};
    std::vector<Inspection> all;
    const bool points = arguments->points || is_one_recording(arguments->file);
    std::size_t demonstrations = 0, movements = 0, usable = 0;
    const imports::ImportResult imported =
        for_each_demonstration(arguments->request, [&](Demonstration&& demonstration) {
          Inspection inspection = inspect(demonstration, options);
          ++demonstrations;
          movements += inspection.movements.size();
          usable += inspection.count_usable();
          if (arguments->json) {
            all.push_back(std::move(inspection));
          } else {
            fmt::print("{}", inspection_text(inspection));
            if (points) fmt::print("{}", imports::summary_text(inspection.survey));
          }
        });
    if (arguments->json) {
      fmt::print("{}\n", inspections_json(all, imported.skipped));
    } else {
      fmt::print("{}{}: {}, {}, {} of them usable\n", import_summary_text(imported),
                 arguments->file, count_with_noun(demonstrations, "demonstration"),
                 count_with_noun(movements, "movement"), usable);
    }
    return count_failed(imported) > 0 ? 1 : 0;
  };
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
