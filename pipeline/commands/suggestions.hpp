#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace morphe::commands {

/// Returns the names of the subcommands of a program or command, in order.
std::vector<std::string> command_names(const CLI::App& app);
/// Returns the long names of the options of a command: "--out", "--dataset", …
std::vector<std::string> option_names(const CLI::App& app);

/// Returns the message for a command `word` that does not exist, with similar names or all.
std::string unknown_command(const CLI::App& app, std::string_view word);

/// Returns a line for each option on a command line that its command does not have, "" if there is
/// no such option. To be called after the command line was parsed, successfully or not.
std::string unknown_options(const CLI::App& app);

/// Returns a line for each option that was given more often than it takes values, "" if there is no
/// such option. To be called after the command line was parsed.
std::string repeated_options(const CLI::App& app);

}  // namespace morphe::commands
