#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace morphe::commands {

/// Returns the shell completions of the last word of a command line. `words` are those after the
/// program's name. Commands, options and the values that a check lists come from `app`; the values
/// of other types from completions.cpp: figures, statuses, plans of the file that the line names,
/// keys of a config, shipped files. Files of the user are the shell's own. Nothing is thrown.
std::vector<std::string> completions(const CLI::App& app, const std::vector<std::string>& words);

}  // namespace morphe::commands
