#include "pipeline/commands/paste.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace morphe::commands {
namespace {

/// A word as a POSIX shell takes it.
std::string shell_word(const std::string& word) {
  const bool plain = !word.empty() && word.find_first_not_of(
                                          "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                          "0123456789_-./=:,+%@") == std::string::npos;
  if (plain) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

/// A name as a key of YAML, quoted where it may not stand bare.
std::string yaml_key(const std::string& name) {
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

/// The arguments without an option and its value.
std::vector<std::string> without(std::vector<std::string> arguments, const std::string& option) {
  for (auto at = arguments.begin(); at != arguments.end();) {
    if (*at == option && at + 1 != arguments.end()) {
      at = arguments.erase(at, at + 2);
    } else if (at->starts_with(option + "=")) {
      at = arguments.erase(at);
    } else {
      ++at;
    }
  }
  return arguments;
}

/// The option that answers a key of Conventions: "--joint-order".
std::string option_of(std::string key) {
  std::ranges::replace(key, '_', '-');
  return "--" + key;
}

/// "reach_names.yaml" beside the manifest, or here; with a number if that is somebody's already.
std::string names_file(const imports::ImportQuestion& question) {
  const std::filesystem::path folder = std::filesystem::path(question.manifest).parent_path();
  const std::string stem = std::filesystem::path(question.file).stem().string() + "_names";
  std::string name = stem + ".yaml";
  std::error_code ignored;
  for (int n = 2; std::filesystem::exists(folder / name, ignored); ++n) {
    name = fmt::format("{}_{}.yaml", stem, n);
  }
  return name;
}

std::string proposals(const imports::ImportQuestion& question) {
  std::string text = "proposed:\n";
  for (const auto& [key, guess] : question.proposal.conventions) {
    text += fmt::format("  {} {}: {}, {}\n", option_of(key), shell_word(guess.value),
                        name_of(guess.sure), guess.because);
  }
  if (!question.proposal.names.empty()) {
    text +=
        fmt::format("  --names {}: by their words, as in \"taken for\" above; look through it\n",
                    shell_word(names_file(question)));
  }
  if (question.names_open) {
    text +=
        "  --names: its names tell no arm; map them in a YAML file, a line each such as\n"
        "    RECORDED_NAME: right_shoulder\n"
        "  (right_elbow, right_wrist, right_index_mcp, right_thumb_tip, left_...)\n";
  }
  return text;
}

std::string names_template(const imports::ImportQuestion& question, const std::string& file) {
  std::string text = fmt::format("cat > {} <<'END'\n", shell_word(file));
  for (const auto& [recorded, ours] : question.proposal.names) {
    text += fmt::format("{}: {}\n", yaml_key(recorded), ours);
  }
  return text + "END\n";
}

std::string command_line(const imports::ImportQuestion& question,
                         std::vector<std::string> arguments) {
  for (const auto& [key, guess] : question.proposal.conventions) {
    arguments = without(std::move(arguments), option_of(key));
    arguments.insert(arguments.end(), {option_of(key), guess.value});
  }
  if (!question.proposal.names.empty()) {
    arguments = without(std::move(arguments), "--names");
    arguments.insert(arguments.end(), {"--names", names_file(question)});
  }
  std::string line = "morphe";
  for (const std::string& argument : arguments) line += " " + shell_word(argument);
  return line + "\n";
}

std::string manifest_lines(const imports::ImportQuestion& question) {
  std::string text =
      fmt::format("add to {}, at its top or to the recording's own keys:\n", question.manifest);
  for (const auto& [key, guess] : question.proposal.conventions) {
    text += fmt::format("{}: {}\n", key == "rate" ? "rate_hz" : key, guess.value);
  }
  if (!question.proposal.names.empty()) text += fmt::format("names: {}\n", names_file(question));
  return text;
}

}  // namespace

std::string question_text(const imports::ImportQuestion& question,
                          const std::vector<std::string>& arguments) {
  std::string text = question.survey + proposals(question);
  const bool listed = !question.manifest.empty();
  if (!listed) text += "to paste:\n";
  if (!question.proposal.names.empty()) {
    const auto folder = std::filesystem::path(question.manifest).parent_path();
    if (listed) text += "to paste:\n";
    text += names_template(question, (folder / names_file(question)).string());
  }
  return text + (listed ? manifest_lines(question) : command_line(question, arguments));
}

}  // namespace morphe::commands
