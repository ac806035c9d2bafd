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
#include "pipeline/commands/import_options.hpp"
#include "pipeline/commands/import_summary.hpp"
#include "pipeline/commands/input_file.hpp"

namespace morphe::commands {
namespace {

namespace fs = std::filesystem;

bool has_folder(const imports::ImportRequest& request) {
  return std::ranges::any_of(request.paths,
                             [](const fs::path& path) { return fs::is_directory(path); });
}

/// Imports recordings. If they were found in folders, a manifest is written beside the
/// demonstrations, but not beside clips.
int execute(const imports::ImportRequest& request, const fs::path& out, const fs::path& clips) {
  if (out.empty() && clips.empty()) {
    throw InputError("import: needs --out FILE.h5, --clip DIR or both");
  }
  const bool of_folder = !out.empty() && has_folder(request);
  const GeneratedManifest manifest(fs::path(out).replace_extension(".recordings.yaml"));
  if (of_folder) manifest.expect_replaceable();
  Assumptions assumptions;
  ClipOutput clip_output(clips);
  const auto see = [&](const Demonstration& demonstration) {
    assumptions.add(demonstration);
    if (!clips.empty()) clip_output.add(demonstration);
  };
  const imports::ImportResult imported =
      out.empty() ? imports::import_recordings(
                        request, [&](Demonstration&& demonstration) { see(demonstration); })
                  : imports::write_demonstrations(request, out, see);
  fmt::print(stderr, "{}", import_summary_text(imported));
  if (of_folder) manifest.write(imported);
  if (!clips.empty()) fmt::print("{}", clip_output.text());
  if (!out.empty()) {
    fmt::print("{}: {}\n", out.string(), count_with_noun(imported.entries.size(), "demonstration"));
  }
  fmt::print("{}", assumptions.text());
  return count_failed(imported) > 0 ? 1 : 0;
}

}  // namespace

Command import_command(CLI::App& app) {
  struct Arguments {
    imports::ImportRequest request;
    std::string out, clips;
  };
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("PATH", arguments->request.paths,
                 "Recordings, folders of recordings, or manifests (.yaml) that list them")
      ->required()
      ->transform(input_file());
  app.add_option("--out", arguments->out, "The demonstrations.h5 to write");
  app.add_option(
      "--clip", arguments->clips,
      "Folder in which each demonstration is written as a clip (.npz) of joints and objects");
  add_import_options(app, arguments->request);
  return [arguments] { return execute(arguments->request, arguments->out, arguments->clips); };
}

}  // namespace morphe::commands
