#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace morphe::commands {

/// A command of the program: adds its arguments to its subcommand and returns what to run once they
/// are parsed. The result is the exit code; InputError is caught in main.
using Command = std::function<int()>;
Command diff_command(CLI::App& app);
Command doctor_command(CLI::App& app);
Command explain_command(CLI::App& app);
Command export_command(CLI::App& app);
Command import_command(CLI::App& app);
Command inspect_command(CLI::App& app);
Command list_command(CLI::App& app);
Command merge_command(CLI::App& app);
Command place_command(CLI::App& app);
Command report_command(CLI::App& app);
Command robot_command(CLI::App& app);
Command run_command(CLI::App& app);
Command schema_command(CLI::App& app);
Command simulate_command(CLI::App& app);
Command synthesize_command(CLI::App& app);
Command study_command(CLI::App& app);
Command verify_command(CLI::App& app);

}  // namespace morphe::commands
