#include "pipeline/commands/import_question_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace morphe::commands {
namespace {

std::string quote_for_shell(const std::string& word) {
  const bool plain = !word.empty() && word.find_first_not_of(
                                          "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                          "0123456789_-./=:,+%@") == std::string::npos;
  if (plain) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

/// Returns a name as a key of YAML, quoted if necessary.
std::string quote_yaml_key(const std::string& name) {
  const bool plain =
      name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") ==
          std::string::npos &&
      name.find_first_not_of("0123456789") != std::string::npos;
  if (plain) return name;
  std::string quoted = "\"";
  for (const char c : name) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

std::vector<std::string> remove_option(std::vector<std::string> arguments,
                                       const std::string& option) {
  for (auto word = arguments.begin(); word != arguments.end();) {
    if (*word == option && word + 1 != arguments.end()) {
      word = arguments.erase(word, word + 2);
    } else if (word->starts_with(option + "=")) {
      word = arguments.erase(word);
    } else {
      ++word;
    }
  }
  return arguments;
}

/// Returns the option for a key of imports::Conventions, such as "--joint-order".
std::string option_of(std::string key) {
  std::ranges::replace(key, '_', '-');
  return "--" + key;
}

/// Returns the name of a new file beside the manifest or in the current folder: "reach_names.yaml".
std::string names_file(const imports::UnresolvedImport& question) {
  const std::filesystem::path folder = std::filesystem::path(question.manifest).parent_path();
  const std::string stem = std::filesystem::path(question.file).stem().string() + "_names";
  std::string name = stem + ".yaml";
  std::error_code ignored;
  for (int n = 2; std::filesystem::exists(folder / name, ignored); ++n)
    name = fmt::format("{}_{}.yaml", stem, n);
  return name;
}

std::string proposals_text(const imports::UnresolvedImport& question) {
  std::string text = "proposed:\n";
  for (const auto& [key, guess] : question.proposal.conventions)
    text += fmt::format("  {} {}: {}, {}\n", option_of(key), quote_for_shell(guess.value),
                        name_of(guess.confidence), guess.reason);
  if (!question.proposal.names.empty())
    text += fmt::format(
        "  --names {}: guessed from the words in the names, see \"used as\" above; check them\n",
        quote_for_shell(names_file(question)));
  if (question.names_unresolved)
    text +=
        "  --names: no arm found in its names; map them in a YAML file, one line per name, such "
        "as\n"
        "    RECORDED_NAME: right_shoulder\n"
        "  (right_elbow, right_wrist, right_index_mcp, right_thumb_tip, left_...)\n";
  return text;
}

std::string names_template(const imports::UnresolvedImport& question, const std::string& file) {
  std::string text = fmt::format("cat > {} <<'END'\n", quote_for_shell(file));
  for (const auto& [recorded, ours] : question.proposal.names)
    text += fmt::format("{}: {}\n", quote_yaml_key(recorded), ours);
  return text + "END\n";
}

std::string command_line(const imports::UnresolvedImport& question,
                         std::vector<std::string> arguments) {
  for (const auto& [key, guess] : question.proposal.conventions) {
    arguments = remove_option(std::move(arguments), option_of(key));
    arguments.insert(arguments.end(), {option_of(key), guess.value});
  }
  if (!question.proposal.names.empty()) {
    arguments = remove_option(std::move(arguments), "--names");
    arguments.insert(arguments.end(), {"--names", names_file(question)});
  }
  std::string line = "morphe";
  for (const std::string& argument : arguments) line += " " + quote_for_shell(argument);
  return line + "\n";
}

std::string manifest_lines(const imports::UnresolvedImport& question) {
  std::string text = fmt::format("add to {}, at the top level or to the entry of the recording:\n",
                                 question.manifest);
  for (const auto& [key, guess] : question.proposal.conventions)
    text += fmt::format("{}: {}\n", key == "rate" ? "rate_hz" : key, guess.value);
  if (!question.proposal.names.empty()) text += fmt::format("names: {}\n", names_file(question));
  return text;
}

}  // namespace

std::string import_question_text(const imports::UnresolvedImport& question,
                                 const std::vector<std::string>& arguments) {
  std::string text = question.summary + proposals_text(question);
  const bool listed = !question.manifest.empty(), named = !question.proposal.names.empty();
  if (!listed || named) text += "to paste:\n";
  if (named) {
    const auto folder = std::filesystem::path(question.manifest).parent_path();
    text += names_template(question, (folder / names_file(question)).string());
  }
  return text + (listed ? manifest_lines(question) : command_line(question, arguments));
}

}  // namespace morphe::commands
