#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace morphe::commands {

/// A command of the program. Each of the following functions adds the arguments of a command to its
/// subcommand and returns the function to run after parsing. The result is the exit code;
/// InputError is caught in main.
using Command = std::function<int()>;
/// Adds `morphe diff`.
Command diff_command(CLI::App& app);
/// Adds `morphe doctor`.
Command doctor_command(CLI::App& app);
/// Adds `morphe explain`.
Command explain_command(CLI::App& app);
/// Adds `morphe export`.
Command export_command(CLI::App& app);
/// Adds `morphe import`.
Command import_command(CLI::App& app);
/// Adds `morphe inspect`.
Command inspect_command(CLI::App& app);
/// Adds `morphe list`.
Command list_command(CLI::App& app);
/// Adds `morphe merge`.
Command merge_command(CLI::App& app);
/// Adds `morphe place`.
Command place_command(CLI::App& app);
/// Adds `morphe report`.
Command report_command(CLI::App& app);
/// Adds `morphe robot`.
Command robot_command(CLI::App& app);
/// Adds `morphe run`.
Command run_command(CLI::App& app);
/// Adds `morphe schema`.
Command schema_command(CLI::App& app);
/// Adds `morphe simulate`.
Command simulate_command(CLI::App& app);
/// Adds `morphe synthesize`.
Command synthesize_command(CLI::App& app);
/// Adds `morphe study`.
Command study_command(CLI::App& app);
/// Adds `morphe verify`.
Command verify_command(CLI::App& app);

}  // namespace morphe::commands
