#include "pipeline/commands/suggestions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <set>

#include "core/config/spelling_hint.hpp"

namespace morphe::commands {
namespace {

/// Returns the command that the words name, following them as far as possible.
const CLI::App& command_of(const CLI::App& app, const std::vector<std::string>& words) {
  const CLI::App* command = &app;
  for (const std::string& word : words) {
    const auto inner =
        command->get_subcommands([&](const CLI::App* sub) { return sub->get_name() == word; });
    if (inner.empty()) break;
    command = inner.front();
  }
  return *command;
}

bool takes_value(const CLI::App& app, const std::string& name) {
  const CLI::Option* const option = app.get_option_no_throw(name);
  return option && option->get_expected_max() > 0;
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
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  std::string lines;
  for (const std::string& word : command->remaining()) {
    if (word.size() < 2 || word[0] != '-') continue;
    const std::string name = word.substr(0, word.find('='));
    lines += fmt::format("{}: unknown option {}{}\n", command->get_name(), name,
                         config::spelling_hint(name, option_names(*command)));
  }
  return lines;
}

std::vector<std::string> completions(const CLI::App& app, const std::vector<std::string>& words) {
  if (words.empty()) return {};
  const std::vector<std::string> before(words.begin(), words.end() - 1);
  const CLI::App& command = command_of(app, before);
  if (!before.empty() && takes_value(command, before.back())) return {};
  const std::string& prefix = words.back();
  std::set<std::string> names;
  for (const std::string& name :
       prefix.starts_with('-') ? option_names(command) : command_names(command))
    if (name.starts_with(prefix)) names.insert(name);
  if (prefix.starts_with('-') && std::string_view("--help").starts_with(prefix))
    names.insert("--help");
  return {names.begin(), names.end()};
}

}  // namespace morphe::commands
