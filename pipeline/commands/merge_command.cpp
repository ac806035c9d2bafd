#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "core/motion/input_error.hpp"
#include "pipeline/commands/commands.hpp"
#include "pipeline/run/journal.hpp"
#include "pipeline/run/merge.hpp"
#include "pipeline/run/output_folder.hpp"

namespace morphe::commands {
namespace {

namespace fs = std::filesystem;

struct MergeArguments {
  std::vector<std::string> folders;
  std::string out;
  bool strict = false, json = false;
};

int execute(const MergeArguments& arguments) {
  run::OutputFolder out(arguments.out);
  if (fs::exists(out.path() / run::Journal::kFile))
    throw InputError(
        fmt::format("{}: is the folder of a run; its plans.h5 is not replaced: give another --out",
                    out.path().string()));
  const fs::path plans = out.path() / "plans.h5";
  const run::BatchSummary summary =
      run::merge_shards({arguments.folders.begin(), arguments.folders.end()}, plans);
  out.keep();
  fmt::print("{}\n", arguments.json
                         ? run::summary_json(summary)
                         : fmt::format("{}: {}", plans.string(), run::summary_sentence(summary)));
  if (summary.failed > 0) return 1;
  return arguments.strict && summary.infeasible > 0 ? 1 : 0;
}

CommandAction add_merge_arguments(CLI::App& app) {
  const auto arguments = std::make_shared<MergeArguments>();
  app.add_option("DIR", arguments->folders, "Folders of all shards of one run")->required();
  app.add_option("--out", arguments->out, "Folder for the merged plans.h5")->required();
  app.add_flag("--strict", arguments->strict, "Exit 1 if a movement is infeasible");
  app.add_flag("--json", arguments->json, "Print JSON");
  return [arguments] { return execute(*arguments); };
}

}  // namespace

Command merge_command() {
  return {"merge", "Join the shards of a run into one plans.h5",
          "  morphe run configs/pipelines/pa10_dlr_hit2.yaml --out outputs/shards/1 --shard 1/2\n"
          "  morphe run configs/pipelines/pa10_dlr_hit2.yaml --out outputs/shards/2 --shard 2/2\n"
          "  morphe merge outputs/shards/1 outputs/shards/2 --out outputs/merged\n",
          add_merge_arguments};
}

}  // namespace morphe::commands
