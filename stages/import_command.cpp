#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "pipeline/store/demonstration_file.hpp"
#include "stages/commands.hpp"
#include "stages/import/import.hpp"

namespace morphe {

Command import_command(CLI::App& app) {
  struct Arguments {
    ImportRequest request;
    std::string out;
  };
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("PATH", arguments->request.paths,
                 "Recordings, or manifests (.yaml) that list them")
      ->required();
  app.add_option("--out", arguments->out, "The demonstrations.h5 to write")->required();
  app.add_option("--static", arguments->request.static_trial, "Static trial of the recordings");
  app.add_option("--format", arguments->request.format, "Format, if not to be told by content")
      ->check(CLI::IsMember(import_format_names()));
  app.add_option("--names", arguments->request.names, "YAML map of recorded names to ours");
  app.add_option("--axes", arguments->request.conventions.axes,
                 "Recorded axes that point right, forward and up, such as 'x y z'");
  app.add_option("--unit", arguments->request.conventions.unit,
                 "Unit of lengths: m, cm, mm, in or metres per unit");
  app.add_option("--rate", arguments->request.conventions.rate_hz, "Frames a second")
      ->check(CLI::PositiveNumber);
  return [arguments] {
    DemonstrationWriter writer(arguments->out);
    const std::size_t count = import_recordings(
        arguments->request, [&](Demonstration&& demonstration) { writer.add(demonstration); });
    writer.finish();
    fmt::print("{}: {} demonstrations\n", arguments->out, count);
    return 0;
  };
}

}  // namespace morphe
