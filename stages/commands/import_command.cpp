#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "stages/commands/assumptions.hpp"
#include "stages/commands/commands.hpp"
#include "stages/commands/import_options.hpp"
#include "stages/commands/input_file.hpp"

namespace morphe::commands {

Command import_command(CLI::App& app) {
  struct Arguments {
    imports::ImportRequest request;
    std::string out;
  };
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("PATH", arguments->request.paths,
                 "Recordings, or manifests (.yaml) that list them")
      ->required()
      ->transform(input_file());
  app.add_option("--out", arguments->out, "The demonstrations.h5 to write")->required();
  add_import_options(app, arguments->request);
  return [arguments] {
    Assumptions assumptions;
    const std::size_t count = imports::write_demonstrations(
        arguments->request, arguments->out,
        [&](const Demonstration& demonstration) { assumptions.add(demonstration); });
    fmt::print("{}: {} demonstrations\n{}", arguments->out, count, assumptions.text());
    return 0;
  };
}

}  // namespace morphe::commands
