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
#include "stages/commands/paste.hpp"

namespace {

struct Entry {
  const char* name;
  const char* description;
  morphe::commands::Command (*add)(CLI::App&);
};

constexpr std::array<Entry, 14> kCommands{{
    {"diff", "Compare two plans.h5: which plans differ, and by how much",
     morphe::commands::diff_command},
    {"explain", "Tell what became of a movement, and what to try where it is infeasible",
     morphe::commands::explain_command},
    {"export", "Write executable plans as CSV, ROS or robomimic files",
     morphe::commands::export_command},
    {"import", "Convert recordings into a demonstrations.h5", morphe::commands::import_command},
    {"inspect", "Show what a recording or demonstrations.h5 holds, and what cannot be used",
     morphe::commands::inspect_command},
    {"list", "Print the table of a plans.h5: its plans, sorted or some of them",
     morphe::commands::list_command},
    {"merge", "Join the shards of a run into one plans.h5", morphe::commands::merge_command},
    {"place", "Find where a robot's base should stand for a dataset",
     morphe::commands::place_command},
    {"report", "Write a page that plays every plan of a plans.h5 in a browser",
     morphe::commands::report_command},
    {"robot", "Check, print and draw a robot description", morphe::commands::robot_command},
    {"run", "Plan recorded demonstrations: write DIR/plans.h5", morphe::commands::run_command},
    {"synthesize", "Generate recordings with known ground truth",
     morphe::commands::synthesize_command},
    {"study", "Run a study: write its figures to DIR/results.json",
     morphe::commands::study_command},
    {"verify", "Check a plans.h5 with independent code, from the file alone",
     morphe::commands::verify_command},
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
      "Morphe turns recorded human reaches and grasps into executable robot trajectories.\n"
      "Shipped files (configs/..., datasets/...) are found from any folder.",
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
  } catch (const morphe::imports::ImportQuestion& question) {
    fmt::print(stderr, "{}\n{}", question.what(),
               morphe::commands::question_text(question, {argv + 1, argv + argc}));
  } catch (const morphe::InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
  } catch (const std::exception& error) {
    fmt::print(stderr, "morphe: {}\n", error.what());
  }
  return kBadInput;
}
