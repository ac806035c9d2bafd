#include "stages/commands/import_options.hpp"

#include <CLI/CLI.hpp>

#include "stages/commands/input_file.hpp"

namespace morphe::commands {

void add_import_options(CLI::App& app, imports::ImportRequest& request) {
  app.add_option("--static", request.static_trial, "Static trial of the recordings")
      ->transform(input_file());
  app.add_option("--format", request.format, "Format, if not to be told by content")
      ->check(CLI::IsMember(imports::import_format_names()));
  app.add_option("--names", request.names, "YAML map of recorded names to ours")
      ->transform(input_file());
  app.add_option("--axes", request.conventions.axes,
                 "Recorded axes that point right, forward and up, such as 'x y z'");
  app.add_option("--unit", request.conventions.unit,
                 "Unit of lengths: m, cm, mm, in or metres per unit");
  app.add_option("--rate", request.conventions.rate_hz, "Frames a second")
      ->check(CLI::PositiveNumber);
}

}  // namespace morphe::commands
