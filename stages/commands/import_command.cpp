#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>

#include "stages/commands/assumptions.hpp"
#include "stages/commands/commands.hpp"
#include "stages/commands/dataset_input.hpp"
#include "stages/commands/import_options.hpp"
#include "stages/commands/input_file.hpp"

namespace morphe::commands {
namespace {

namespace fs = std::filesystem;

int execute(const imports::ImportRequest& request, const fs::path& out) {
  const bool of_folder = std::ranges::any_of(
      request.paths, [](const fs::path& path) { return fs::is_directory(path); });
  const FoundManifest manifest(fs::path(out).replace_extension(".recordings.yaml"));
  if (of_folder) manifest.check();
  Assumptions assumptions;
  const imports::Imported imported = imports::write_demonstrations(
      request, out, [&](const Demonstration& demonstration) { assumptions.add(demonstration); });
  fmt::print(stderr, "{}", found_text(imported));
  if (of_folder) manifest.write(imported);
  const std::size_t count = imported.entries.size();
  fmt::print("{}: {} demonstration{}\n{}", out.string(), count, count == 1 ? "" : "s",
             assumptions.text());
  return failed_in(imported) > 0 ? 1 : 0;
}

}  // namespace

Command import_command(CLI::App& app) {
  struct Arguments {
    imports::ImportRequest request;
    std::string out;
  };
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("PATH", arguments->request.paths,
                 "Recordings, folders of them, or manifests (.yaml) that list them")
      ->required()
      ->transform(input_file());
  app.add_option("--out", arguments->out, "The demonstrations.h5 to write")->required();
  add_import_options(app, arguments->request);
  return [arguments] { return execute(arguments->request, arguments->out); };
}

}  // namespace morphe::commands
