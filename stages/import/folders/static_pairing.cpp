#include "stages/import/folders/static_pairing.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <tuple>

#include "stages/import/recording/name_words.hpp"

namespace morphe::imports {
namespace {

using NameWords = std::vector<NameWord>;

constexpr std::size_t kMinSharedPoints = 3;

struct RecordingNameWords {
  std::vector<NameWords> folders;
  NameWords name;
};

struct StaticTrialWords {
  std::vector<NameWords> scope_folders;  ///< its folders that are not named like static trials
  NameWords person;  ///< beginning of candidate_words that is a person's name; may be empty
  NameWords candidate_words;  ///< words of its name that may be a person's name
  NameWords all;              ///< every word of its name
  bool has_person = false;    ///< true if `person` is known
};

bool begins_with(const NameWords& words, std::span<const NameWord> beginning) {
  return words.size() >= beginning.size() &&
         std::ranges::equal(std::span(words).first(beginning.size()), beginning);
}

/// Returns true if the recording's name continues the person's, or a folder of it has this name.
bool matches_person(const RecordingNameWords& trial, std::span<const NameWord> person) {
  if (person.empty()) return false;
  if (trial.name.size() > person.size() && begins_with(trial.name, person)) return true;
  return std::ranges::any_of(
      trial.folders, [&](const NameWords& folder) { return std::ranges::equal(folder, person); });
}

/// Returns true if both have the same letters, but different numbers: ADL001 and ADL002.
bool differs_in_number(std::span<const NameWord> a, std::span<const NameWord> b) {
  if (a.size() != b.size()) return false;
  bool letters = false, number = false;
  for (int i = 0; i < std::ssize(a); ++i) {
    const bool equal = a[i] == b[i];
    if (a[i].number != b[i].number || (!a[i].number && !equal)) return false;
    letters = letters || !a[i].number;
    number = number || !equal;
  }
  return letters && number;
}

bool is_other_person(const RecordingNameWords& trial, const StaticTrialWords& static_trial) {
  const NameWords& person = static_trial.candidate_words;
  if (person.empty()) return false;
  if (trial.name.size() > person.size() &&
      differs_in_number(std::span(trial.name).first(person.size()), person)) {
    return true;
  }
  return std::ranges::any_of(
      trial.folders, [&](const NameWords& folder) { return differs_in_number(folder, person); });
}

/// Returns true if the folders are all among the recording's, in the same order.
bool is_in_scope(const RecordingNameWords& trial, const std::vector<NameWords>& folders) {
  auto next = folders.begin();
  for (const NameWords& folder : trial.folders) {
    if (next != folders.end() && folder == *next) ++next;
  }
  return next == folders.end();
}

RecordingNameWords recording_name_words(const RecordingDescriptor& descriptor) {
  RecordingNameWords words;
  for (const std::string& folder : descriptor.folders) words.folders.push_back(split_name(folder));
  words.name = split_name(descriptor.stem);
  return words;
}

/// Sets `person` to the longest prefix of the candidate words that is the person of a recording. If
/// the words have a number, the prefix ends with one: letters alone may be any person's.
void find_person_words(StaticTrialWords& static_trial,
                       const std::vector<RecordingNameWords>& trials) {
  const bool has_number = std::ranges::any_of(static_trial.candidate_words, &NameWord::number);
  for (std::size_t length = static_trial.candidate_words.size(); length > 0; --length) {
    const auto beginning = std::span(static_trial.candidate_words).first(length);
    if (length < static_trial.candidate_words.size() && has_number && !beginning.back().number)
      continue;
    if (std::ranges::any_of(
            trials, [&](const RecordingNameWords& t) { return matches_person(t, beginning); })) {
      static_trial.person.assign(beginning.begin(), beginning.end());
      static_trial.has_person = true;
      return;
    }
  }
}

StaticTrialWords static_trial_words(const RecordingDescriptor& descriptor,
                                    const std::vector<RecordingNameWords>& trials) {
  StaticTrialWords static_trial;
  for (const std::string& folder : descriptor.folders) {
    if (!parse_static_name(folder).is_static)
      static_trial.scope_folders.push_back(split_name(folder));
  }
  static_trial.candidate_words = parse_static_name(descriptor.stem).person_words;
  static_trial.all = split_name(descriptor.stem);
  find_person_words(static_trial, trials);
  return static_trial;
}

std::size_t shared_points(const RecordingDescriptor& a, const RecordingDescriptor& b) {
  std::vector<std::string> shared;
  std::ranges::set_intersection(a.points, b.points, std::back_inserter(shared));
  return shared.size();
}

std::size_t shared_words(const NameWords& a, const NameWords& b) {
  return std::ranges::count_if(
      a, [&](const NameWord& word) { return std::ranges::find(b, word) != b.end(); });
}

/// Returns the person's name as the recording ("ADL001" of ADL001DR2) or its folder spells it.
std::string person_name(const RecordingDescriptor& descriptor, const RecordingNameWords& trial,
                        const NameWords& person) {
  if (trial.name.size() > person.size() && begins_with(trial.name, person))
    return descriptor.stem.substr(0, trial.name[person.size() - 1].end);
  const auto folder = std::ranges::find(trial.folders, person);
  return folder == trial.folders.end() ? "" : descriptor.folders[folder - trial.folders.begin()];
}

}  // namespace

std::vector<std::optional<StaticPair>> pair_static_trials(
    const std::vector<RecordingDescriptor>& recordings,
    const std::vector<RecordingDescriptor>& statics) {
  std::vector<RecordingNameWords> trials;
  for (const RecordingDescriptor& descriptor : recordings)
    trials.push_back(recording_name_words(descriptor));
  std::vector<StaticTrialWords> static_words;
  for (const RecordingDescriptor& descriptor : statics)
    static_words.push_back(static_trial_words(descriptor, trials));

  std::vector<std::optional<StaticPair>> pairs(recordings.size());
  for (int i = 0; i < std::ssize(recordings); ++i) {
    const RecordingDescriptor& recording = recordings[i];
    const RecordingNameWords& trial = trials[i];
    using Fit = std::tuple<std::size_t, std::size_t, bool, std::size_t, std::size_t>;
    std::optional<Fit> best_fit;
    int candidate_count = 0;
    for (int k = 0; k < std::ssize(statics); ++k) {
      const StaticTrialWords& static_trial = static_words[k];
      const bool by_name = matches_person(trial, static_trial.person);
      if (statics[k].format != recording.format || is_other_person(trial, static_trial)) continue;
      if (static_trial.has_person ? !by_name : !is_in_scope(trial, static_trial.scope_folders))
        continue;
      const std::size_t point_count = shared_points(recording, statics[k]);
      if (point_count < std::min(kMinSharedPoints, recording.points.size())) continue;
      const bool below = is_in_scope(trial, static_trial.scope_folders);
      // In another branch of the folders only a name with a number is reliable.
      if (!below && std::ranges::none_of(static_trial.person, &NameWord::number)) continue;
      const Fit fit{below ? static_trial.scope_folders.size() + 1 : 0,
                    by_name ? static_trial.person.size() : 0,
                    statics[k].subject == recording.subject, point_count,
                    shared_words(trial.name, static_trial.all)};
      ++candidate_count;
      if (best_fit && *best_fit >= fit) continue;
      best_fit = fit;
      pairs[i] = {k, by_name ? person_name(recording, trial, static_trial.person) : "", 0};
    }
    if (pairs[i]) pairs[i]->candidate_count = candidate_count;
  }
  return pairs;
}

}  // namespace morphe::imports
