#pragma once

#include <array>
#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace morphe::commands {

/// The function that a command runs after its arguments were parsed; it returns the exit code.
using CommandAction = std::function<int()>;

/// A command of the program.
struct Command {
  std::string name, description;
  /// Command lines, printed by --help. They work in a folder with Morphe's configs and datasets.
  /// They may use the results of the examples of `run`.
  std::string examples;
  /// Adds the arguments to the subcommand and returns the function to run after parsing, whose
  /// result is the exit code. It may throw InputError.
  std::function<CommandAction(CLI::App&)> add_arguments;
};

/// Each function returns the command of its name: diff_command() returns `morphe diff`.
Command diff_command();
Command doctor_command();
Command explain_command();
Command export_command();
Command import_command();
Command inspect_command();
Command list_command();
Command merge_command();
Command place_command();
Command report_command();
Command robot_command();
Command run_command();
Command schema_command();
Command simulate_command();
Command synthesize_command();
Command study_command();
Command verify_command();

/// All commands, in the order of --help.
inline constexpr std::array kCommands{
    diff_command,    doctor_command, explain_command, export_command,   import_command,
    inspect_command, list_command,   merge_command,   place_command,    report_command,
    robot_command,   run_command,    schema_command,  simulate_command, synthesize_command,
    study_command,   verify_command,
};

}  // namespace morphe::commands
