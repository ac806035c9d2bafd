#include "stages/import/guess/import_question.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "stages/import/guess/name_guess.hpp"
#include "stages/import/guess/name_map.hpp"
#include "stages/import/guess/plausible.hpp"
#include "stages/import/guess/survey.hpp"
#include "stages/import/recording/arm_names.hpp"

namespace morphe::imports {
namespace {

/// What stands in for a convention while a recording is looked at (joint_order.hpp needs nothing).
void stand_in(Conventions& conventions, const std::string& key) {
  if (key == "axes") conventions.axes = "x y z";
  if (key == "unit") conventions.unit = "1";
  if (key == "rate") conventions.rate_hz = 1;
}

/// The recording as it stands in the file, whatever it does not say; `open` is taken as not said.
Demonstration look(const RecordingFormat& format, RecordingFiles files, const std::string& open) {
  std::set<std::string> replaced = {open};
  files.conventions.judged = false;
  stand_in(files.conventions, open);
  while (true) {
    try {
      return format.read(files);
    } catch (const NotSaid& missing) {
      if (!replaced.insert(missing.key).second) throw;
      stand_in(files.conventions, missing.key);
    }
  }
}

Demonstration read_judged(const RecordingFormat& format, const RecordingFiles& files) {
  Demonstration demonstration = format.read(files);
  check_plausible(files.file.string(), demonstration);
  return demonstration;
}

/// Names of the recording, then those that its static trial alone shows.
std::vector<std::string> names_in(const Demonstration& demonstration, Side hand) {
  std::vector<std::string> names = recorded_points(demonstration.streams, hand).names;
  for (const std::string& name : recorded_points(demonstration.calibration, hand).names) {
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  return names;
}

bool has_names(const Demonstration& demonstration) {
  return demonstration.streams.markers || demonstration.streams.skeleton;
}

/// Names that are Morphe's already.
GuessedNames known_of(const std::vector<std::string>& names) {
  GuessedNames known;
  for (const std::string& name : names) {
    if (!body_part(name).empty()) known.emplace_back(name, name);
  }
  return known;
}

/// Whether an arm, or the shape of a hand, could be rebuilt from them.
bool are_an_arm(const GuessedNames& names) {
  const auto any = [&](std::initializer_list<const char*> parts) {
    return std::ranges::any_of(names, [&](const auto& entry) {
      const std::string part = body_part(entry.second);
      return std::ranges::any_of(
          parts, [&](const char* wanted) { return part.find(wanted) != std::string::npos; });
    });
  };
  const auto tips = std::ranges::count_if(
      names, [](const auto& entry) { return body_part(entry.second).ends_with(" tip"); });
  const bool whole_hand = any({"wrist"}) && tips >= 5 && names.size() >= 21;
  return whole_hand ||
         (any({"shoulder", "upper arm"}) && any({"elbow", "forearm"}) && any({"wrist", "hand"}));
}

/// What of an arm can be told from names that are none of Morphe's; nothing for what is known.
GuessedNames guess_names(const Demonstration& seen, const GuessedNames& known, Side hand) {
  const RecordedPoints points = recorded_points(seen.streams, hand);
  GuessedNames guessed = points.parents.empty() ? guess_points(names_in(seen, hand), hand)
                                                : guess_joints(points.names, points.parents);
  std::erase_if(guessed, [&](const auto& entry) {
    return std::ranges::any_of(known, [&](const auto& own) {
      return own.first == entry.first || own.second == entry.second;
    });
  });
  return guessed;
}

GuessedNames joined(GuessedNames a, const GuessedNames& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

Guess guess_of(const NotSaid& missing, const RecordingFormat& format, const RecordingFiles& files) {
  const std::string& key = missing.key;
  if (key == "joint_order") {
    return {missing.likely, Sureness::guessed, "the likeliest by how the joints lie"};
  }
  const RecordedPoints points = recorded_points(look(format, files, key).streams, files.hand);
  Guess guess = key == "axes"   ? guess_axes(points)
                : key == "unit" ? guess_unit(points)
                                : guess_rate(points, 1);
  if (!guess.value.empty()) return guess;
  return {key == "axes"   ? "x y z"
          : key == "unit" ? "mm"
                          : "100",
          Sureness::guessed, "nothing in the recording tells it: put in what is true"};
}

void answer(Conventions& conventions, const std::string& key, const std::string& value) {
  if (key == "axes") conventions.axes = value;
  if (key == "unit") conventions.unit = value;
  if (key == "rate") conventions.rate_hz = std::stod(value);
  if (key == "joint_order") conventions.joint_order = value;
}

/// Answers what is asked until the recording is read, or asks the same again.
struct Answers {
  std::vector<std::string> lines;
  Proposal proposal;
};

void answer_all(const RecordingFormat& format, RecordingFiles files, Answers& answers) {
  std::set<std::string> answered;
  std::optional<NotSaid> order;
  while (true) {
    try {
      read_judged(format, files);
      return;
    } catch (const NotSaid& missing) {
      if (missing.key == "joint_order") order = missing;
      // Joints in the wrong order have no sizes either.
      if (!answered.insert(missing.key).second) throw order.value_or(missing);
      answers.lines.emplace_back(missing.what());
      Guess guess = guess_of(missing, format, files);
      answer(files.conventions, missing.key, guess.value);
      answers.proposal.conventions.emplace_back(missing.key, std::move(guess));
    }
  }
}

[[noreturn]] void ask_all(const RecordingFormat& format, const RecordingFiles& files,
                          const std::string& manifest, const Demonstration& seen,
                          const GuessedNames& names, bool whole) {
  RecordingFiles named = files;
  Answers answers;
  if (!names.empty()) {
    named.renamed = NameMap(names.begin(), names.end());
    answers.proposal.names = names;
  }
  answer_all(format, named, answers);
  if (!names.empty()) {
    answers.lines.push_back(fmt::format(
        "{}: names: none of its names is one that Morphe knows; give --names or `names:`",
        files.file.string()));
  }
  ImportQuestion question(fmt::format("{}", fmt::join(answers.lines, "\n")));
  question.file = files.file.string();
  question.manifest = manifest;
  Survey survey = survey_of(recorded_points(seen.streams, files.hand), named.renamed);
  survey.file = question.file;
  survey.unit = "m";
  for (const auto& [key, guess] : answers.proposal.conventions) {
    if (key == "unit") survey.unit.clear();
    if (key == "rate") survey.rate_hz = 0;
  }
  question.survey = survey_text(survey);
  question.names_open = has_names(seen) && files.renamed.empty() &&
                        !are_an_arm(joined(known_of(names_in(seen, files.hand)), names));
  if (whole && answers.proposal.conventions.empty()) question.without_names = seen;
  question.proposal = std::move(answers.proposal);
  throw question;
}

Demonstration read_with(const ShippedNames& shipped, const RecordingFormat& format,
                        RecordingFiles files, const std::string& manifest) {
  const std::string said =
      fmt::format("names as {} maps them: all of its names were recorded", shipped.file.string());
  files.renamed = shipped.names;
  try {
    Demonstration demonstration = read_or_ask(format, files, manifest);
    demonstration.reports.push_back(said);
    return demonstration;
  } catch (ImportQuestion& question) {
    question.survey += said + "\n";
    throw;
  }
}

}  // namespace

Demonstration read_or_ask(const RecordingFormat& format, const RecordingFiles& files,
                          const std::string& manifest) {
  std::optional<Demonstration> read;
  std::string open;
  try {
    read = read_judged(format, files);
    const bool told = !files.renamed.empty() || !has_names(*read);
    if (told || are_an_arm(known_of(names_in(*read, files.hand)))) return std::move(*read);
  } catch (const NotSaid& missing) {
    open = missing.key;
  }
  const Demonstration seen = read ? *read : look(format, files, open);
  const GuessedNames known = known_of(names_in(seen, files.hand));
  GuessedNames guessed;
  if (files.renamed.empty() && has_names(seen) && !are_an_arm(known)) {
    if (const auto shipped = shipped_names_for(names_in(seen, files.hand))) {
      return read_with(*shipped, format, files, manifest);
    }
    guessed = guess_names(seen, known, files.hand);
  }
  if (read && !are_an_arm(joined(known, guessed))) return std::move(*read);
  ask_all(format, files, manifest, seen, guessed, read.has_value());
}

}  // namespace morphe::imports
