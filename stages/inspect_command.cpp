#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "pipeline/store/demonstration_file.hpp"
#include "stages/commands.hpp"
#include "stages/inspect_report.hpp"
#include "stages/pipeline_config.hpp"

namespace morphe {
namespace {

InspectOptions options_of(const std::string& config) {
  if (config.empty()) return {};
  const PipelineConfig options = load_config(config).options;
  return {options.reconstruct, options.human, options.segment};
}

}  // namespace

Command inspect_command(CLI::App& app) {
  struct Arguments {
    std::string file, config;
    bool json = false;
  };
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("FILE", arguments->file, "demonstrations.h5")->required();
  app.add_option("--config", arguments->config,
                 "Pipeline config to rebuild and segment by (default: every default)");
  app.add_flag("--json", arguments->json, "Print JSON");
  return [arguments] {
    const InspectOptions options = options_of(arguments->config);
    const DemonstrationReader reader(arguments->file);
    std::vector<Inspection> all;
    std::size_t movements = 0, usable = 0;
    for (std::size_t i = 0; i < reader.size(); ++i) {
      Inspection inspection = inspect(reader.read(i), options);
      movements += inspection.movements.size();
      usable += inspection.usable();
      if (arguments->json) {
        all.push_back(std::move(inspection));
      } else {
        fmt::print("{}", inspection_text(inspection));
      }
    }
    if (arguments->json) {
      fmt::print("{}\n", inspections_json(all));
    } else {
      fmt::print("{}: {} demonstrations, {} movements, {} of them usable\n", arguments->file,
                 reader.size(), movements, usable);
    }
    return 0;
  };
}

}  // namespace morphe
