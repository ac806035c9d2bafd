#include "stages/import/guess/unresolved_import.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "stages/import/guess/constants.hpp"
#include "stages/import/guess/name_guess.hpp"
#include "stages/import/guess/name_map.hpp"
#include "stages/import/guess/plausibility.hpp"
#include "stages/import/guess/recording_summary.hpp"
#include "stages/import/recording/arm_names.hpp"
#include "stages/import/recording/assumption_notes.hpp"
#include "stages/import/recording/repeated_rows.hpp"

namespace morphe::imports {
namespace {

void set_convention(Conventions& conventions, const std::string& key, const std::string& value) {
  if (key == "axes") conventions.axes = value;
  if (key == "unit") conventions.unit = value;
  if (key == "rate") conventions.rate_hz = std::stod(value);
  if (key == "joint_order") conventions.joint_order = value;
}

/// Sets a convention to a value with which a recording can be inspected in its own coordinates. A
/// joint order need not be set: without plausibility checks the likeliest one is used.
void set_placeholder(Conventions& conventions, const std::string& key) {
  if (key != "joint_order") set_convention(conventions, key, key == "axes" ? "x y z" : "1");
}

Demonstration read_checked(const RecordingFormat& format, const RecordingFiles& files) {
  Demonstration demonstration = read_distinct_rows(format, files);
  check_plausibility(files.file.string(), demonstration);
  return demonstration;
}

/// Returns the names of the recording, then those that only its static trial has.
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

/// Returns the names that are already Morphe's, each mapped to itself.
GuessedNames recognised_names(const std::vector<std::string>& names) {
  GuessedNames known;
  for (const std::string& name : names) {
    if (!body_part(name).empty()) known.emplace_back(name, name);
  }
  return known;
}

int count_tips(const GuessedNames& names) {
  return static_cast<int>(std::ranges::count_if(
      names, [](const auto& entry) { return body_part(entry.second).ends_with(" tip"); }));
}

/// Returns true if the names are a wrist's and those of five fingertips.
bool cover_a_hand(const GuessedNames& names) {
  constexpr int kFingers = 5;
  return count_tips(names) >= kFingers && std::ranges::any_of(names, [](const auto& entry) {
           return body_part(entry.second).ends_with(" wrist");
         });
}

/// Returns true if an arm, or the keypoints of a hand, can be reconstructed from the names.
bool cover_an_arm(const GuessedNames& names) {
  const auto any = [&](std::initializer_list<const char*> parts) {
    return std::ranges::any_of(names, [&](const auto& entry) {
      const std::string part = body_part(entry.second);
      return std::ranges::any_of(
          parts, [&](const char* word) { return part.find(word) != std::string::npos; });
    });
  };
  return (cover_a_hand(names) && names.size() >= kHandPointCount) ||
         (any({"shoulder", "upper arm"}) && any({"elbow", "forearm"}) && any({"wrist", "hand"}));
}

/// Guesses the parts of an arm from names that are not Morphe's, except for parts already known.
GuessedNames guess_names(const Demonstration& seen, const GuessedNames& known, Side hand) {
  const RecordedPoints points = recorded_points(seen.streams, hand);
  GuessedNames guessed = points.parents.empty() ? guess_points(names_in(seen, hand), hand)
                                                : guess_joints(points.names, points.parents, hand);
  std::erase_if(guessed, [&](const auto& entry) {
    return std::ranges::any_of(known, [&](const auto& own) {
      return own.first == entry.first || own.second == entry.second;
    });
  });
  return guessed;
}

GuessedNames merged_names(GuessedNames a, const GuessedNames& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

Guess guess_of(const UnresolvedConvention& missing, const RecordingFormat& format,
               const RecordingFiles& files) {
  const std::string& key = missing.key;
  if (key == "joint_order") {
    return {missing.likely_value, Confidence::guessed,
            "best match for the positions of the joints"};
  }
  const RecordedPoints points =
      recorded_points(read_unchecked(format, files, key).streams, files.hand);
  Guess guess = key == "axes"   ? guess_axes(points)
                : key == "unit" ? guess_unit(points)
                                : guess_rate(points, 1);
  const bool usual_known = key == "axes" && !missing.likely_value.empty();
  if (usual_known && (guess.value.empty() || guess.confidence == Confidence::guessed))
    return {missing.likely_value, Confidence::guessed,
            "usual in such files; the recording does not tell; enter the true ones"};
  if (!guess.value.empty()) return guess;
  return {key == "axes"   ? "x y z"
          : key == "unit" ? "mm"
                          : "100",
          Confidence::guessed, "cannot be derived from the recording; enter the true value"};
}

/// Throws the error about a convention with which no proposed value makes the recording plausible.
[[noreturn]] void throw_unanswerable(const UnresolvedConvention& missing) {
  if (missing.key != "unit") throw missing;
  throw UnresolvedConvention(
      "unit", fmt::format("{}; mm, cm, m, in and ft do not make it plausible: names or positions "
                          "cannot be right",
                          missing.what()));
}

/// Proposes conventions until the recording can be read, and adds a line of the message for each.
/// Throws UnresolvedConvention if the recording cannot be read with the proposed value of one.
void propose_conventions(const RecordingFormat& format, RecordingFiles files,
                         std::vector<std::string>& lines, Proposal& proposal) {
  std::map<std::string, UnresolvedConvention> asked;  // by key: as it was missing at first
  while (true) {
    try {
      read_checked(format, files);
      return;
    } catch (const UnresolvedConvention& missing) {
      const auto [first, is_new] = asked.emplace(missing.key, missing);
      // A hand with its joints in the wrong order has no plausible unit: report the order instead.
      if (!is_new) {
        const auto order = asked.find("joint_order");
        throw_unanswerable(order == asked.end() ? first->second : order->second);
      }
      lines.emplace_back(missing.what());
      Guess guess = guess_of(missing, format, files);
      set_convention(files.conventions, missing.key, guess.value);
      proposal.conventions.emplace_back(missing.key, std::move(guess));
    } catch (const InputError&) {  // such as fingers that curl to the wrong side
      if (asked.contains("joint_order")) throw UnresolvedConvention(asked.at("joint_order"));
      throw;
    }
  }
}

[[noreturn]] void throw_unresolved(const RecordingFormat& format, const RecordingFiles& files,
                                   const std::string& manifest, const Demonstration& seen,
                                   const GuessedNames& names, bool readable) {
  RecordingFiles named = files;
  if (!names.empty()) named.name_map = NameMap(names.begin(), names.end());
  std::vector<std::string> lines;
  Proposal proposal{names, {}};
  propose_conventions(format, named, lines, proposal);
  if (!names.empty()) {
    lines.push_back(
        fmt::format("{}: names: none of the recorded names is known; give --names or `names:`",
                    files.file.string()));
  }
  UnresolvedImport question(fmt::format("{}", fmt::join(lines, "\n")));
  question.file = files.file.string();
  question.manifest = manifest;
  question.static_trial = files.static_trial.string();
  question.given = files.conventions;
  if (files.hand == Side::left) question.hand = files.hand;
  RecordingSummary summary =
      summarise_points(recorded_points(seen.streams, files.hand), named.name_map);
  summary.file = question.file;
  summary.unit = "m";
  for (const auto& [key, guess] : proposal.conventions) {
    if (key == "unit") summary.unit.clear();
    if (key == "rate") summary.rate_hz = 0;
  }
  question.summary = summary_text(summary);
  const GuessedNames all = merged_names(recognised_names(names_in(seen, files.hand)), names);
  question.names_unresolved =
      has_names(seen) && files.name_map.empty() && !cover_an_arm(all) && !cover_a_hand(all);
  if (readable && proposal.conventions.empty()) question.demonstration = seen;
  question.proposal = std::move(proposal);
  throw question;
}

Demonstration read_with_name_map(const ShippedNameMap& shipped, const RecordingFormat& format,
                                 RecordingFiles files, const std::string& manifest) {
  const std::string note = fmt::format("{} {}, whose names are all in the recording", kNamesMapped,
                                       shipped.file.filename().string());
  files.name_map = shipped.names;
  try {
    Demonstration demonstration = read_or_propose(format, files, manifest);
    demonstration.import_notes.push_back(note);
    return demonstration;
  } catch (UnresolvedImport& question) {
    question.summary += note + "\n";
    throw;
  }
}

}  // namespace

Demonstration read_distinct_rows(const RecordingFormat& format, const RecordingFiles& files) {
  Demonstration demonstration = format.read(files);
  drop_repeated_rows(files.file.string(), demonstration);
  return demonstration;
}

Demonstration read_unchecked(const RecordingFormat& format, RecordingFiles files,
                             const std::string& key) {
  std::set<std::string> replaced = {key};
  files.conventions.plausibility_checks = false;
  set_placeholder(files.conventions, key);
  while (true) {
    try {
      return read_distinct_rows(format, files);
    } catch (const UnresolvedConvention& missing) {
      if (!replaced.insert(missing.key).second) throw;
      set_placeholder(files.conventions, missing.key);
    }
  }
}

UnresolvedImport UnresolvedImport::with_message(const std::string& message) const {
  UnresolvedImport other = *this;
  static_cast<InputError&>(other) = InputError(message);
  return other;
}

Demonstration read_or_propose(const RecordingFormat& format, const RecordingFiles& files,
                              const std::string& manifest) {
  std::optional<Demonstration> read;
  std::string missing_key;
  try {
    read = read_checked(format, files);
    const bool names_given = !files.name_map.empty() || !has_names(*read);
    if (names_given || cover_an_arm(recognised_names(names_in(*read, files.hand))))
      return std::move(*read);
  } catch (const UnresolvedConvention& missing) {
    missing_key = missing.key;
  }
  const Demonstration seen = read ? *read : read_unchecked(format, files, missing_key);
  const GuessedNames known = recognised_names(names_in(seen, files.hand));
  GuessedNames guessed;
  if (files.name_map.empty() && has_names(seen) && !cover_an_arm(known)) {
    if (const auto shipped = find_shipped_names(names_in(seen, files.hand)))
      return read_with_name_map(*shipped, format, files, manifest);
    guessed = guess_names(seen, known, files.hand);
  }
  if (read && !cover_an_arm(merged_names(known, guessed))) return std::move(*read);
  throw_unresolved(format, files, manifest, seen, guessed, read.has_value());
}

}  // namespace morphe::imports
