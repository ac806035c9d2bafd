#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <functional>
#include <map>
#include <new>
#include <sstream>
#include <string>
#include <vector>

#include "core/motion/input_error.hpp"
#include "core/motion/version.hpp"
#include "core/store/hdf5_exit.hpp"
#include "pipeline/commands/commands.hpp"
#include "pipeline/commands/completions.hpp"
#include "pipeline/commands/import_question_text.hpp"
#include "pipeline/commands/man_page.hpp"
#include "pipeline/commands/standard_streams.hpp"
#include "pipeline/commands/suggestions.hpp"
#include "pipeline/commands/value_checks.hpp"
#include "pipeline/run/abnormal_end.hpp"
#include "pipeline/run/stop_signal.hpp"

namespace {

namespace commands = morphe::commands;

constexpr int kInputErrorExitCode = 2;
constexpr const char* kOutOfMemory = "out of memory";

/// Returns true if the processor supports the instructions for which the program was compiled.
bool is_cpu_supported() {
#if defined(__AVX2__) && defined(__FMA__)
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return true;
#endif
}

int print_usage_error(const std::string& message, const std::string& command) {
  fmt::print(stderr, "{}\nSee morphe {}--help.\n", message, command);
  return kInputErrorExitCode;
}

int complete(const CLI::App& app, int argc, char** argv) {
  const std::vector<std::string> words(argv + 2, argv + argc);
  for (const std::string& word : commands::completions(app, words)) fmt::print("{}\n", word);
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
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on file sizes is an error like a full disk
  CLI::App app(
      "Morphe turns recorded human reaches and grasps into executable robot trajectories.\n"
      "Shipped files (configs/..., datasets/...) are found from every folder.",
      "morphe");
  app.set_version_flag("--version", morphe::software());
  app.require_subcommand(1);
  std::map<const CLI::App*, morphe::commands::CommandAction> actions;
  for (const auto command_of : commands::kCommands) {
    const commands::Command command = command_of();
    CLI::App* const subcommand = app.add_subcommand(command.name, command.description);
    subcommand->footer("Examples:\n" + command.examples);
    actions[subcommand] = command.add_arguments(*subcommand);
  }
  commands::check_values(app);
  const std::string first = argc > 1 ? argv[1] : "";
  const std::string command = first.starts_with('-') ? "" : first + " ";
  if (first == "--complete") return complete(app, argc, argv);
  if (first == "--man") {
    fmt::print("{}", commands::man_page(app));
    return 0;
  }
  if (!first.empty() && first[0] != '-') {
    const std::vector<std::string> names = commands::command_names(app);
    if (std::ranges::find(names, first) == names.end())
      return print_usage_error(commands::unknown_command(app, first), "");
  }
  try {
    morphe::run::watch_stop_signals();
    app.parse(argc, argv);
    return actions.at(app.get_subcommands().front())();
  } catch (const CLI::ParseError& error) {
    const std::string unknown = commands::unknown_options(app);
    if (error.get_exit_code() != 0 && !unknown.empty())
      return print_usage_error(unknown.substr(0, unknown.size() - 1), command);
    const std::string repeated = commands::repeated_options(app);
    if (error.get_exit_code() != 0 && !repeated.empty())
      return print_usage_error(repeated.substr(0, repeated.size() - 1), command);
    return print_parse_error(app, error);
  } catch (const morphe::imports::UnresolvedImport& question) {
    fmt::print(stderr, "{}\n{}", question.what(),
               commands::import_question_text(question, {argv + 1, argv + argc}));
  } catch (const morphe::InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "morphe: %s\n", kOutOfMemory);
  } catch (const std::exception& error) {
    fmt::print(stderr, "morphe: {}\n", error.what());
  }
  return kInputErrorExitCode;
}

}  // namespace

int main(int argc, char** argv) {
  morphe::run::report_abnormal_ends();
  morphe::store::close_nothing_at_exit();
  int code = kInputErrorExitCode;
  try {
    commands::guard_standard_streams();
    code = commands::flush_standard_output(execute(argc, argv));
  } catch (const std::exception&) {  // not even the message of an error could be made
    std::fprintf(stderr, "morphe: %s\n", kOutOfMemory);
  }
  morphe::run::expect_end();
  return code;
}
