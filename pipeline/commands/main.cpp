#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include "core/motion/input_error.hpp"
#include "core/motion/version.hpp"
#include "pipeline/commands/commands.hpp"
#include "pipeline/commands/examples.hpp"
#include "pipeline/commands/import_question_text.hpp"
#include "pipeline/commands/standard_streams.hpp"
#include "pipeline/commands/suggestions.hpp"
#include "pipeline/run/stop_signal.hpp"

namespace {

struct CommandEntry {
  const char* name;
  const char* description;
  morphe::commands::Command (*add)(CLI::App&);
};

constexpr std::array<CommandEntry, 17> kCommands{{
    {"diff", "Compare two plans.h5: which plans differ, and by how much",
     morphe::commands::diff_command},
    {"doctor", "Check whether this system has everything that Morphe needs",
     morphe::commands::doctor_command},
    {"explain", "Explain the result of a movement, and what to try if it is infeasible",
     morphe::commands::explain_command},
    {"export", "Write executable plans as CSV, ROS or robomimic files",
     morphe::commands::export_command},
    {"import", "Convert recordings into a demonstrations.h5", morphe::commands::import_command},
    {"inspect", "Show the content of a recording or demonstrations.h5, and what cannot be used",
     morphe::commands::inspect_command},
    {"list", "Print the table of plans in a plans.h5, sorted or filtered",
     morphe::commands::list_command},
    {"merge", "Join the shards of a run into one plans.h5", morphe::commands::merge_command},
    {"place", "Find the best placement of a robot's base for a dataset",
     morphe::commands::place_command},
    {"report", "Write a page that plays every plan of a plans.h5 in a browser",
     morphe::commands::report_command},
    {"robot", "Check, print and draw a robot description", morphe::commands::robot_command},
    {"run", "Plan recorded demonstrations: write DIR/plans.h5", morphe::commands::run_command},
    {"schema", "Print the JSON schema of a kind of YAML file, for editors",
     morphe::commands::schema_command},
    {"simulate", "Simulate whether the grasps of a plans.h5 hold",
     morphe::commands::simulate_command},
    {"synthesize", "Generate recordings with known ground truth",
     morphe::commands::synthesize_command},
    {"study", "Run a study: write its figures to DIR/results.json",
     morphe::commands::study_command},
    {"verify", "Check a plans.h5 with independent code, using only the file",
     morphe::commands::verify_command},
}};

constexpr int kInputErrorExitCode = 2;

/// Returns true if the processor supports the instructions for which the program was compiled.
bool is_cpu_supported() {
#if defined(__AVX2__) && defined(__FMA__)
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return true;
#endif
}

/// Adds examples to the help of each command.
void add_examples(CLI::App& app, const std::string& before) {
  for (CLI::App* const command : app.get_subcommands({})) {
    const std::string name = before + command->get_name();
    command->footer(morphe::commands::examples_of(name));
    add_examples(*command, name + " ");
  }
}

int print_usage_error(const std::string& wrong, const std::string& command) {
  fmt::print(stderr,
             "{}\n"
             "See morphe {}--help.\n",
             wrong, command);
  return kInputErrorExitCode;
}

/// Implements `morphe --complete WORD…` for the shell.
int complete(const CLI::App& app, int argc, char** argv) {
  const std::vector<std::string> words(argv + 2, argv + argc);
  for (const std::string& word : morphe::commands::completions(app, words))
    fmt::print("{}\n", word);
  return 0;
}

/// Prints the output of --help and --version, or the errors of a command line.
int print_parse_error(const CLI::App& app, const CLI::ParseError& error) {
  std::ostringstream out, err;
  const int code = app.exit(error, out, err);
  fmt::print("{}", out.str());
  fmt::print(stderr, "{}", err.str());
  return code == 0 ? 0 : kInputErrorExitCode;
}

int execute(int argc, char** argv) {
  if (!is_cpu_supported()) {
    std::fputs("morphe: built for processors with AVX2 and FMA (see MORPHE_ARCH)\n", stderr);
    return kInputErrorExitCode;
  }
  morphe::run::watch_stop_signals();
  std::signal(
      SIGXFSZ,
      SIG_IGN);  // exceeding a limit on file sizes is reported as an error, like a full disk
  CLI::App app(
      "Morphe turns recorded human reaches and grasps into executable robot trajectories.\n"
      "Shipped files (configs/..., datasets/...) are found from every folder.",
      "morphe");
  app.set_version_flag("--version", morphe::software());
  app.require_subcommand(1);
  std::array<morphe::commands::Command, kCommands.size()> commands;
  for (std::size_t i = 0; i < kCommands.size(); ++i) {
    commands[i] =
        kCommands[i].add(*app.add_subcommand(kCommands[i].name, kCommands[i].description));
  }
  add_examples(app, "");
  const std::string first = argc > 1 ? argv[1] : "";
  if (first == "--complete") return complete(app, argc, argv);
  if (!first.empty() && first[0] != '-') {
    const std::vector<std::string> names = morphe::commands::command_names(app);
    if (std::ranges::find(names, first) == names.end())
      return print_usage_error(morphe::commands::unknown_command(app, first), "");
  }
  try {
    app.parse(argc, argv);
    for (std::size_t i = 0; i < kCommands.size(); ++i) {
      if (app.got_subcommand(kCommands[i].name)) return commands[i]();
    }
  } catch (const CLI::ParseError& error) {
    const std::string unknown = morphe::commands::unknown_options(app);
    if (error.get_exit_code() != 0 && !unknown.empty())
      return print_usage_error(unknown.substr(0, unknown.size() - 1), first + " ");
    return print_parse_error(app, error);
  } catch (const morphe::imports::UnresolvedImport& question) {
    fmt::print(stderr, "{}\n{}", question.what(),
               morphe::commands::import_question_text(question, {argv + 1, argv + argc}));
  } catch (const morphe::InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
  } catch (const std::exception& error) {
    fmt::print(stderr, "morphe: {}\n", error.what());
  }
  return kInputErrorExitCode;
}

}  // namespace

int main(int argc, char** argv) {
  morphe::commands::guard_standard_streams();
  return morphe::commands::flush_standard_output(execute(argc, argv));
}
