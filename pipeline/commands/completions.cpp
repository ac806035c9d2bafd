#include "pipeline/commands/completions.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <filesystem>
#include <functional>
#include <set>
#include <string_view>
#include <system_error>

#include "core/files/data_files.hpp"
#include "core/store/plan_file.hpp"
#include "pipeline/commands/plan_row.hpp"
#include "pipeline/commands/plans_file.hpp"
#include "pipeline/commands/suggestions.hpp"
#include "pipeline/planning/config_schema.hpp"
#include "pipeline/report/selection.hpp"

namespace morphe::commands {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

/// The part of a command line before the word to complete.
struct LineBefore {
  const CLI::App* command = nullptr;
  const CLI::Option* option = nullptr;  ///< that expects a value, null if there is none
  int values_left = 0;                  ///< number of values that it still expects
  Words arguments;                      ///< of the command, without options and their values
};

int value_count(const CLI::Option& option) {
  return option.get_items_expected_max() >= CLI::detail::expected_max_vector_size
             ? 1
             : std::max(1, option.get_items_expected_min());
}

LineBefore parse_before(const CLI::App& app, const Words& words) {
  LineBefore line{&app, nullptr, 0, {}};
  for (const std::string& word : words) {
    if (word == "=") continue;  // bash splits --option=value
    if (line.values_left > 0 && --line.values_left >= 0) {
      if (line.values_left == 0) line.option = nullptr;
      continue;
    }
    const auto inner = line.command->get_subcommands(
        [&](const CLI::App* command) { return command->get_name() == word; });
    if (word.starts_with('-')) {
      const CLI::Option* const option = line.command->get_option_no_throw(word);
      if (!option || option->get_expected_max() == 0) continue;
      line.option = option;
      line.values_left = value_count(*option);
    } else if (!inner.empty() && line.arguments.empty()) {
      line.command = inner.front();
    } else {
      line.arguments.push_back(word);
    }
  }
  return line;
}

/// Returns the positional argument that comes next, null if no more is expected.
const CLI::Option* next_argument(const LineBefore& line) {
  const auto positionals =
      line.command->get_options([](const CLI::Option* option) { return option->get_positional(); });
  std::size_t taken = line.arguments.size();
  for (const CLI::Option* const option : positionals) {
    const auto most = static_cast<std::size_t>(option->get_items_expected_max());
    if (taken < most) return option;
    taken -= most;
  }
  return nullptr;
}

Words plan_names(const LineBefore& line) {
  Words names;
  for (const std::string& argument : line.arguments) {
    for (const fs::path& file : find_plans_files(argument)) {
      const store::PlanReader reader(file);
      for (const std::string& path : reader.plan_paths()) {
        names.push_back(path);
        names.push_back(path.substr(0, path.rfind('/')));
      }
    }
  }
  return names;
}

Words filters(const LineBefore& line) {
  Words words = filter_words();
  try {
    for (std::string& name : plan_names(line)) words.push_back(std::move(name));
  } catch (const std::exception&) {  // no plans yet
  }
  return words;
}

/// Adds "KEY=" for each key of a schema, and "KEY=WORD" for each word of an enumeration.
void add_keys(const config::Schema& schema, const std::string& above, Words& keys) {
  if (!schema.contains("properties")) return;
  for (const auto& [name, value] : schema["properties"].items()) {
    const std::string key = above + name;
    if (value.contains("properties")) {
      add_keys(value, key + ".", keys);
      continue;
    }
    keys.push_back(key + "=");
    if (!value.contains("enum")) continue;
    for (const auto& word : value["enum"])
      if (word.is_string()) keys.push_back(key + "=" + word.get<std::string>());
  }
}

Words config_keys(const LineBefore& /*line*/) {
  Words keys;
  add_keys(planning::config_schema([](const auto&, const auto&) { return std::string(); }), "",
           keys);
  return keys;
}

/// The values of a type of option or argument.
struct ValueList {
  const char* type;  ///< its type, or its name if it is positional
  std::function<Words(const LineBefore&)> values;
};

const std::vector<ValueList>& value_lists() {
  static const std::vector<ValueList> lists{
      {"KEY", [](const LineBefore&) { return sort_keys(); }},
      {"WHAT", filters},
      {"PLAN", plan_names},
      {"N BY", [](const LineBefore&) { return report::ranking_measure_names(); }},
      {"KEY=VALUE", config_keys},
      {"UNIT",
       [](const LineBefore&) {
         return Words{"m", "cm", "mm", "in", "ft"};
       }},
      {"GROUP",
       [](const LineBefore&) {
         return Words{"all", "arm", "hand"};
       }},
  };
  return lists;
}

/// Returns the shipped files below the folder of an unfinished path; nothing where the user's own
/// folder has the same name.
Words shipped_files(const std::string& prefix) {
  const fs::path folder = fs::path(prefix).parent_path();
  Words names;
  for (const char* const top : {"configs", "datasets"}) {
    const bool inside = *folder.begin() == top;
    const fs::path named = inside ? folder : fs::path(top);
    const fs::path shipped = files::resolve_data_file(named);
    if ((!folder.empty() && !inside) || shipped == named) continue;
    if (!inside) names.push_back(fmt::format("{}/", top));
    if (!inside) continue;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(shipped, ignored))
      names.push_back((folder / entry.path().filename()).string() +
                      (entry.is_directory(ignored) ? "/" : ""));
  }
  return names;
}

Words values_of(const CLI::Option& option, const LineBefore& line, const std::string& prefix) {
  const std::string type = option.get_type_name();
  const std::size_t open = type.find('{'), close = type.rfind('}');
  if (open != std::string::npos && close != std::string::npos)
    return CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
  if (type == "FILE") return shipped_files(prefix);
  const std::string name = option.get_positional() ? option.get_name() : type;
  const auto list = std::ranges::find(value_lists(), name, &ValueList::type);
  return list == value_lists().end() ? Words() : list->values(line);
}

Words candidates(const LineBefore& line, const std::string& prefix) {
  if (line.option) return values_of(*line.option, line, prefix);
  if (prefix.starts_with('-')) {
    Words names = option_names(*line.command);
    names.emplace_back("--help");
    return names;
  }
  Words words = line.arguments.empty() ? command_names(*line.command) : Words();
  if (const CLI::Option* const argument = next_argument(line))
    for (std::string& value : values_of(*argument, line, prefix)) words.push_back(std::move(value));
  return words;
}

}  // namespace

Words completions(const CLI::App& app, const Words& words) {
  if (words.empty()) return {};
  LineBefore line = parse_before(app, {words.begin(), words.end() - 1});
  std::string prefix = words.back() == "=" ? "" : words.back();
  std::string before_value;
  const std::size_t equals = prefix.find('=');
  if (!line.option && prefix.starts_with("--") && equals != std::string::npos) {
    line.option = line.command->get_option_no_throw(prefix.substr(0, equals));
    if (!line.option) return {};
    before_value = prefix.substr(0, equals + 1);
    prefix.erase(0, equals + 1);
  }
  std::set<std::string> names;
  try {
    for (const std::string& name : candidates(line, prefix))
      if (name.starts_with(prefix)) names.insert(before_value + name);
  } catch (const std::exception&) {  // a file that cannot be read has no names
  }
  return {names.begin(), names.end()};
}

}  // namespace morphe::commands
