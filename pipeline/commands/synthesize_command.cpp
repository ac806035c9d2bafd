#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "core/config/fields.hpp"
#include "core/files/atomic_file.hpp"
#include "core/motion/count_with_noun.hpp"
#include "core/parallel/ordered_parallel_map.hpp"
#include "core/store/demonstration_file.hpp"
#include "pipeline/commands/commands.hpp"
#include "pipeline/commands/shared_options.hpp"
#include "pipeline/run/output_files.hpp"
#include "pipeline/synthesize/synthesize.hpp"

namespace morphe::commands {
namespace {

namespace fs = std::filesystem;

struct SynthesizeArguments {
  std::string config, out;
  std::size_t count = 100;
  std::uint64_t seed = 1;
  int jobs = 0;
};

synthesize::SynthesizeOptions load_options(const std::string& file) {
  synthesize::SynthesizeOptions options;
  config::read_document(config::ConfigNode::load(file), options);
  return options;
}

/// Returns F.truth.h5 for F.h5.
fs::path truth_file_for(const fs::path& out) {
  fs::path truth = out;
  return truth.replace_extension(".truth" + out.extension().string());
}

int execute(const SynthesizeArguments& arguments) {
  const synthesize::SynthesizeOptions options = load_options(arguments.config);
  files::expect_not_input(arguments.out, arguments.config);
  files::expect_not_input(truth_file_for(arguments.out), arguments.config);
  const run::OutputFiles outputs({arguments.out, truth_file_for(arguments.out)});
  store::DemonstrationWriter recorded(arguments.out), truth(truth_file_for(arguments.out));
  double recorded_s = 0;
  parallel::OrderedParallelMap<std::size_t, synthesize::SyntheticRecording> map;
  map.next = [&, next = std::size_t{0}]() mutable {
    return next == arguments.count ? nullptr : std::make_unique<std::size_t>(next++);
  };
  map.work = [&](std::size_t index) {
    return std::make_unique<synthesize::SyntheticRecording>(
        synthesize::synthesize(options, arguments.seed, index));
  };
  map.write = [&](const synthesize::SyntheticRecording& made) {
    recorded.add(made.recorded);
    truth.add(made.truth);
    recorded_s += made.truth.streams.sensors->time.back();
  };
  parallel::run(map, threads_of(arguments.jobs));
  recorded.finish();
  truth.finish();
  fmt::print("{}: {}, {:.0f} s; ground truth in {}\n", arguments.out,
             count_with_noun(arguments.count, "demonstration"), recorded_s,
             truth_file_for(arguments.out).string());
  return 0;
}

CommandAction add_synthesize_arguments(CLI::App& app) {
  const auto arguments = std::make_shared<SynthesizeArguments>();
  add_input_option(app, "CONFIG", arguments->config,
                   "Config of the recordings to generate (YAML, configs/synthetic)")
      ->required();
  app.add_option("--out", arguments->out,
                 "The demonstrations.h5 to write; the ground truth goes to F.truth.h5 next to it")
      ->required();
  app.add_option("--count", arguments->count, "Number of demonstrations (default: 100)")
      ->check(within(bounds::kCount));
  app.add_option("--seed", arguments->seed, "Random seed (default: 1)");
  add_jobs_option(app, arguments->jobs);
  return [arguments] { return execute(*arguments); };
}

}  // namespace

Command synthesize_command() {
  return {"synthesize", "Generate recordings with known ground truth",
          "  morphe synthesize configs/synthetic/reach_to_grasp.yaml --out outputs/synthetic.h5 "
          "--count 3\n",
          add_synthesize_arguments};
}

}  // namespace morphe::commands
