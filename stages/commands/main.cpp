#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <string_view>

#include "pipeline/motion/input_error.hpp"
#include "pipeline/motion/version.hpp"
#include "stages/commands/commands.hpp"

namespace {

struct Entry {
  const char* name;
  const char* description;
  morphe::commands::Command (*add)(CLI::App&);
};

constexpr std::array<Entry, 10> kCommands{{
    {"diff", "In which plans and by how much two plans.h5 differ", morphe::commands::diff_command},
    {"export", "Executable plans as CSV, ROS or robomimic files", morphe::commands::export_command},
    {"import", "Recordings -> demonstrations.h5", morphe::commands::import_command},
    {"inspect", "What a demonstrations.h5 holds and what will be usable",
     morphe::commands::inspect_command},
    {"merge", "Folders of all shards of a run -> DIR/plans.h5", morphe::commands::merge_command},
    {"robot", "Check, print and draw a robot description", morphe::commands::robot_command},
    {"run", "Demonstrations and a config -> DIR/plans.h5", morphe::commands::run_command},
    {"synthesize", "Recordings that never were, with their truth",
     morphe::commands::synthesize_command},
    {"study", "Figures against ground truth -> DIR/results.json", morphe::commands::study_command},
    {"verify", "Judge a plans.h5 from the file alone", morphe::commands::verify_command},
}};

constexpr int kBadInput = 2;

/// What the compiler was told the machine can do.
bool machine_suffices() {
#if defined(__AVX2__) && defined(__FMA__)
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return true;
#endif
}

bool is_command(std::string_view word) {
  return std::ranges::any_of(kCommands, [&](const Entry& entry) { return word == entry.name; });
}

}  // namespace

int main(int argc, char** argv) {
  if (!machine_suffices()) {
    std::fputs("morphe: built for processors with AVX2 and FMA (see MORPHE_ARCH)\n", stderr);
    return kBadInput;
  }
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on file sizes is an error to be told, like a full disk
  CLI::App app(
      "Morphe: recorded human reaches -> executable robot trajectories\n"
      "A file to read that is not there may be a shipped one: configs/..., datasets/...",
      "morphe");
  app.set_version_flag("--version", morphe::software());
  app.require_subcommand(1);
  std::array<morphe::commands::Command, kCommands.size()> commands;
  for (std::size_t i = 0; i < kCommands.size(); ++i) {
    commands[i] =
        kCommands[i].add(*app.add_subcommand(kCommands[i].name, kCommands[i].description));
  }
  if (const std::string_view word = argc > 1 ? argv[1] : ""; !word.empty() && word[0] != '-') {
    if (!is_command(word)) {
      fmt::print(stderr, "There is no command '{}'\nRun with --help for more information.\n", word);
      return kBadInput;
    }
  }
  try {
    app.parse(argc, argv);
    for (std::size_t i = 0; i < kCommands.size(); ++i) {
      if (app.got_subcommand(kCommands[i].name)) return commands[i]();
    }
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kBadInput;
  } catch (const morphe::InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
  } catch (const std::exception& error) {
    fmt::print(stderr, "morphe: {}\n", error.what());
  }
  return kBadInput;
}
