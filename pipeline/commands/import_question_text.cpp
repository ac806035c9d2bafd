#include "pipeline/commands/import_question_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

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

/// Returns the proposed value, or a placeholder if the recording does not tell.
std::string value_of(const std::string& key, const imports::Guess& guess) {
  if (!guess.value.empty()) return guess.value;
  return option_of(key) == "--static-trial" ? "FILE" : "VALUE";
}

std::string proposals_text(const imports::UnresolvedImport& question) {
  std::string text = "proposed:\n";
  for (const auto& [key, guess] : question.proposal.conventions)
    text += fmt::format("  {} {}: {}, {}\n", option_of(key), quote_for_shell(value_of(key, guess)),
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
    arguments.insert(arguments.end(), {option_of(key), value_of(key, guess)});
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
    text += fmt::format("{}: {}\n", key == "rate" ? "rate_hz" : key, value_of(key, guess));
  if (!question.proposal.names.empty()) text += fmt::format("names: {}\n", names_file(question));
  return text;
}

/// Returns the options with which an import of this recording would have been called.
std::vector<std::string> options_of(const imports::UnresolvedImport& question) {
  const imports::Conventions& given = question.given;
  std::vector<std::string> options;
  const auto add = [&](const std::string& option, const std::string& value) {
    if (!value.empty()) options.insert(options.end(), {option, value});
  };
  add("--static-trial", question.static_trial);
  add("--axes", given.axes);
  add("--unit", given.unit);
  add("--rate", given.rate_hz ? fmt::format("{}", *given.rate_hz) : "");
  add("--joint-order", given.joint_order);
  if (given.forward != imports::ForwardSource::body)
    add("--forward", std::string(name_of(given.forward)));
  if (question.hand) add("--hand", std::string(name_of(*question.hand)));
  return options;
}

/// Returns the name of a file to import into that does not exist: "reach.h5".
std::string output_file(const imports::UnresolvedImport& question) {
  const std::string stem = std::filesystem::path(question.file).stem().string();
  std::string name = stem + ".h5";
  std::error_code ignored;
  for (int n = 2; std::filesystem::exists(name, ignored); ++n)
    name = fmt::format("{}_{}.h5", stem, n);
  return name;
}

/// Returns the lines to paste.
std::string paste_text(const imports::UnresolvedImport& question,
                       const std::vector<std::string>& arguments) {
  std::string text;
  if (!question.proposal.names.empty()) {
    const auto folder = std::filesystem::path(question.manifest).parent_path();
    text += names_template(question, (folder / names_file(question)).string());
  }
  return text +
         (question.manifest.empty() ? command_line(question, arguments) : manifest_lines(question));
}

/// Recordings for which the same is to be stated.
struct SharedQuestion {
  const imports::UnresolvedImport* first;
  std::vector<std::string> files;
};

/// Returns true if one command, or the same lines of a manifest, answer both questions.
bool have_same_answer(const imports::UnresolvedImport& a, const imports::UnresolvedImport& b) {
  const auto& first = a.proposal.conventions;
  const auto& second = b.proposal.conventions;
  const auto same = [](const auto& x, const auto& y) {
    return x.first == y.first && x.second.value == y.second.value;
  };
  return a.manifest == b.manifest && a.proposal.names.empty() && b.proposal.names.empty() &&
         std::ranges::equal(first, second, same) && options_of(a) == options_of(b);
}

std::string shared_question_text(const SharedQuestion& shared) {
  const imports::UnresolvedImport& question = *shared.first;
  std::vector<std::string> arguments{"import"};
  arguments.insert(arguments.end(), shared.files.begin(), shared.files.end());
  for (const std::string& word : options_of(question)) arguments.push_back(word);
  arguments.insert(arguments.end(), {"--out", output_file(question)});
  return fmt::format("for {}\n{}{}", fmt::join(shared.files, ", "), proposals_text(question),
                     paste_text(question, arguments));
}

}  // namespace

std::string import_question_text(const imports::UnresolvedImport& question,
                                 const std::vector<std::string>& arguments) {
  const bool lines_only = !question.manifest.empty() && question.proposal.names.empty();
  return question.summary + proposals_text(question) + (lines_only ? "" : "to paste:\n") +
         paste_text(question, arguments);
}

std::string skipped_questions_text(const std::vector<imports::SkippedFile>& skipped) {
  std::vector<SharedQuestion> questions;
  for (const imports::SkippedFile& file : skipped) {
    if (!file.question) continue;
    const auto same = std::ranges::find_if(questions, [&](const SharedQuestion& other) {
      return have_same_answer(*other.first, *file.question);
    });
    if (same != questions.end()) {
      same->files.push_back(file.file.string());
    } else {
      questions.push_back({file.question.get(), {file.file.string()}});
    }
  }
  std::string text = questions.empty() ? "" : "to import what is asked about, check and paste:\n";
  for (const SharedQuestion& question : questions) text += shared_question_text(question);
  return text;
}

}  // namespace morphe::commands
