#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace morphe::commands {

/// Names of the subcommands of a program or command, in order.
std::vector<std::string> command_names(const CLI::App& app);
/// "--out", "--dataset", … of a command.
std::vector<std::string> option_names(const CLI::App& app);

/// What to say of a command that does not exist.
std::string unknown_command(const CLI::App& app, std::string_view word);

/// A line for each option on a command line that its command does not have, "" if there is none.
/// To be asked after the command line was parsed, or could not be.
std::string unknown_options(const CLI::App& app);

/// For the shell: what the last of these words, which follow the program's name, may become. Empty
/// where it is a file or a free value.
std::vector<std::string> completions(const CLI::App& app, const std::vector<std::string>& words);

}  // namespace morphe::commands
