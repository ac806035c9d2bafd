#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>

#include "core/motion/count_with_noun.hpp"
#include "core/motion/input_error.hpp"
#include "pipeline/commands/assumptions.hpp"
#include "pipeline/commands/clip_output.hpp"
#include "pipeline/commands/commands.hpp"
#include "pipeline/commands/import_summary.hpp"
#include "pipeline/commands/shared_options.hpp"
#include "pipeline/run/output_files.hpp"

namespace morphe::commands {
namespace {

namespace fs = std::filesystem;

/// Imports recordings into the file `out` and the folder `clips`, unless these are empty. If
/// folders were given, a manifest of the recordings is written beside `out`. Returns the exit code.
int execute(const imports::ImportRequest& request, const fs::path& out, const fs::path& clips) {
  if (out.empty() && clips.empty())
    throw InputError("import: needs --out FILE.h5, --clip DIR or both");
  for (const fs::path& path : request.paths) expect_exists(path);
  const bool writes_manifest =
      !out.empty() && std::ranges::any_of(request.paths, [](const fs::path& path) {
        return fs::is_directory(path);
      });
  const fs::path manifest_file = fs::path(out).replace_extension(".recordings.yaml");
  const run::OutputFiles outputs({out, writes_manifest ? manifest_file : fs::path()});
  const GeneratedManifest manifest(manifest_file);
  if (writes_manifest) manifest.expect_replaceable();
  Assumptions assumptions;
  ClipOutput clip_output(clips);
  const auto process = [&](const Demonstration& demonstration) {
    assumptions.add(demonstration);
    if (!clips.empty()) clip_output.add(demonstration);
  };
  const imports::ImportResult imported =
      out.empty() ? imports::import_recordings(
                        request, [&](Demonstration&& demonstration) { process(demonstration); })
                  : imports::write_demonstrations(request, out, process);
  fmt::print(stderr, "{}", import_summary_text(imported));
  if (writes_manifest) manifest.write(manifest.lines(imported));
  if (!clips.empty()) fmt::print("{}", clip_output.text());
  if (!out.empty())
    fmt::print("{}: {}\n", out.string(), count_with_noun(imported.entries.size(), "demonstration"));
  fmt::print("{}", assumptions.text());
  return count_failed(imported) > 0 ? 1 : 0;
}

CommandAction add_import_arguments(CLI::App& app) {
  struct Arguments {
    imports::ImportRequest request;
    std::string out, clips;
  };
  const auto arguments = std::make_shared<Arguments>();
  add_input_option(app, "PATH", arguments->request.paths,
                   "Recordings, folders of recordings, or manifests (.yaml) that list them")
      ->required();
  app.add_option("--out", arguments->out, "The demonstrations.h5 to write");
  app.add_option(
      "--clip", arguments->clips,
      "Folder in which each demonstration is written as a clip (.npz) of joints and objects");
  add_import_options(app, arguments->request);
  return [arguments] { return execute(arguments->request, arguments->out, arguments->clips); };
}

}  // namespace

Command import_command() {
  return {"import", "Convert recordings into a demonstrations.h5",
          "  morphe import datasets/ue-adl/recordings.yaml --out outputs/adl.h5\n"
          "  morphe import datasets/ue-adl/ADL001DR2.csv --static-trial "
          "datasets/ue-adl/ADL001_static.csv --out outputs/one.h5\n",
          add_import_arguments};
}

}  // namespace morphe::commands
