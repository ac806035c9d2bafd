#include "pipeline/commands/suggestions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "core/config/spelling_hint.hpp"

namespace morphe::commands {
namespace {

/// Returns the command that was parsed, or the subcommand of it.
const CLI::App& parsed_command(const CLI::App& app) {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  return *command;
}

}  // namespace

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* const command : app.get_subcommands({}))
    names.push_back(command->get_name());
  return names;
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* const option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

std::string unknown_command(const CLI::App& app, std::string_view word) {
  const std::vector<std::string> names = command_names(app);
  const std::string hint = config::spelling_hint(word, names);
  return fmt::format("unknown command '{}'{}", word,
                     hint.empty() ? fmt::format("; available: {}", fmt::join(names, ", ")) : hint);
}

std::string unknown_options(const CLI::App& app) {
  const CLI::App& command = parsed_command(app);
  std::string lines;
  for (const std::string& word : command.remaining()) {
    if (word.size() < 2 || word[0] != '-') continue;
    const std::string name = word.substr(0, word.find('='));
    lines += fmt::format("{}: unknown option {}{}\n", command.get_name(), name,
                         config::spelling_hint(name, option_names(command)));
  }
  return lines;
}

std::string repeated_options(const CLI::App& app) {
  const CLI::App& command = parsed_command(app);
  std::string lines;
  for (const CLI::Option* const option : command.get_options()) {
    const std::size_t given = option->results().size();
    const auto most = static_cast<std::size_t>(option->get_items_expected_max());
    if (most == 0 || given <= most) continue;
    lines +=
        fmt::format("{}: {} is given more than once\n", command.get_name(), option->get_name());
  }
  return lines;
}

}  // namespace morphe::commands
