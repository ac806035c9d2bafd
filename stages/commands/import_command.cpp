#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "pipeline/store/demonstration_file.hpp"
#include "stages/commands/commands.hpp"
#include "stages/commands/import_options.hpp"

namespace morphe::commands {

Command import_command(CLI::App& app) {
  struct Arguments {
    imports::ImportRequest request;
    std::string out;
  };
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("PATH", arguments->request.paths,
                 "Recordings, or manifests (.yaml) that list them")
      ->required();
  app.add_option("--out", arguments->out, "The demonstrations.h5 to write")->required();
  add_import_options(app, arguments->request);
  return [arguments] {
    store::DemonstrationWriter writer(arguments->out);
    const std::size_t count = imports::import_recordings(
        arguments->request, [&](Demonstration&& demonstration) { writer.add(demonstration); });
    writer.finish();
    fmt::print("{}: {} demonstrations\n", arguments->out, count);
    return 0;
  };
}

}  // namespace morphe::commands
