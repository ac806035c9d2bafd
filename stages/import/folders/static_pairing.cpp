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
  std::vector<NameWords> scope_folders;  ///< folders to which it applies
  NameWords whose;                       ///< words of its name that identify recordings
  NameWords candidate_words;             ///< words that may be a person's name
  NameWords all;                         ///< every word of its name
  bool has_person = false;               ///< true if its name contains a person's
};

bool begins_with(const NameWords& words, std::span<const NameWord> beginning) {
  return words.size() >= beginning.size() &&
         std::ranges::equal(std::span(words).first(beginning.size()), beginning);
}

/// Returns true if the recording has that person's name: its own name begins with it and continues,
/// or a folder has it.
bool matches_person(const RecordingNameWords& trial, std::span<const NameWord> whose) {
  if (whose.empty()) return false;
  if (trial.name.size() > whose.size() && begins_with(trial.name, whose)) return true;
  return std::ranges::any_of(
      trial.folders, [&](const NameWords& folder) { return std::ranges::equal(folder, whose); });
}

/// Returns true for the same letters and another number: ADL001 and ADL002.
bool differs_in_number(std::span<const NameWord> a, std::span<const NameWord> b) {
  if (a.size() != b.size()) return false;
  bool letters = false, number = false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].number != b[i].number) return false;
    if (!a[i].number && !(a[i] == b[i])) return false;
    letters = letters || !a[i].number;
    number = number || !(a[i] == b[i]);
  }
  return letters && number;
}

bool is_other_person(const RecordingNameWords& trial, const StaticTrialWords& still) {
  const NameWords& claimed = still.candidate_words;
  if (claimed.empty()) return false;
  if (trial.name.size() > claimed.size() &&
      differs_in_number(std::span(trial.name).first(claimed.size()), claimed)) {
    return true;
  }
  return std::ranges::any_of(
      trial.folders, [&](const NameWords& folder) { return differs_in_number(folder, claimed); });
}

/// Returns true if the folders of `home` are among the recording's, in the same order.
bool is_in_scope(const RecordingNameWords& trial, const std::vector<NameWords>& home) {
  std::size_t found = 0;
  for (const NameWords& folder : trial.folders) {
    if (found < home.size() && folder == home[found]) ++found;
  }
  return found == home.size();
}

RecordingNameWords recording_name_words(const RecordingDescriptor& sketch) {
  RecordingNameWords place;
  for (const std::string& folder : sketch.folders) place.folders.push_back(split_name(folder));
  place.name = split_name(sketch.stem);
  return place;
}

/// Finds the longest prefix of the candidate words that occurs in recordings: "P01 right" applies
/// to P01's. A prefix without the number could be any person's name.
void find_person_words(StaticTrialWords& still, const std::vector<RecordingNameWords>& trials) {
  const bool has_number = std::ranges::any_of(still.candidate_words, &NameWord::number);
  for (std::size_t length = still.candidate_words.size(); length > 0; --length) {
    const auto beginning = std::span(still.candidate_words).first(length);
    if (length < still.candidate_words.size() && has_number && !beginning.back().number) continue;
    if (std::ranges::any_of(
            trials, [&](const RecordingNameWords& t) { return matches_person(t, beginning); })) {
      still.whose.assign(beginning.begin(), beginning.end());
      still.has_person = true;
      return;
    }
  }
}

StaticTrialWords static_trial_words(const RecordingDescriptor& sketch,
                                    const std::vector<RecordingNameWords>& trials) {
  StaticTrialWords still;
  for (const std::string& folder : sketch.folders) {
    if (!parse_static_name(folder).is_static) still.scope_folders.push_back(split_name(folder));
  }
  still.candidate_words = parse_static_name(sketch.stem).person_words;
  still.all = split_name(sketch.stem);
  find_person_words(still, trials);
  return still;
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

/// Returns "ADL001" for "ADL001DR2"; for a folder, its whole name.
std::string person_name(const RecordingDescriptor& sketch, const RecordingNameWords& trial,
                        const NameWords& whose) {
  if (trial.name.size() > whose.size() && begins_with(trial.name, whose)) {
    return sketch.stem.substr(0, trial.name[whose.size() - 1].end);
  }
  for (std::size_t k = 0; k < trial.folders.size(); ++k) {
    if (trial.folders[k] == whose) return sketch.folders[k];
  }
  return "";
}

}  // namespace

std::vector<std::optional<StaticPair>> pair_static_trials(
    const std::vector<RecordingDescriptor>& recordings,
    const std::vector<RecordingDescriptor>& statics) {
  std::vector<RecordingNameWords> trials;
  for (const RecordingDescriptor& sketch : recordings)
    trials.push_back(recording_name_words(sketch));
  std::vector<StaticTrialWords> places;
  for (const RecordingDescriptor& sketch : statics)
    places.push_back(static_trial_words(sketch, trials));

  std::vector<std::optional<StaticPair>> pairs(recordings.size());
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    const RecordingDescriptor& recording = recordings[i];
    const RecordingNameWords& trial = trials[i];
    using Fit = std::tuple<std::size_t, std::size_t, bool, std::size_t, std::size_t>;
    std::optional<Fit> best;
    std::size_t choice = 0;
    for (std::size_t k = 0; k < statics.size(); ++k) {
      const StaticTrialWords& still = places[k];
      const bool by_name = matches_person(trial, still.whose);
      if (statics[k].format != recording.format || is_other_person(trial, still)) continue;
      if (still.has_person ? !by_name : !is_in_scope(trial, still.scope_folders)) continue;
      const std::size_t points = shared_points(recording, statics[k]);
      if (points < std::min(kMinSharedPoints, recording.points.size())) continue;
      const bool below = is_in_scope(trial, still.scope_folders);
      // In another branch of the folders only a name with a number is reliable.
      if (!below && std::ranges::none_of(still.whose, &NameWord::number)) continue;
      const Fit fit{below ? still.scope_folders.size() + 1 : 0, by_name ? still.whose.size() : 0,
                    statics[k].subject == recording.subject, points,
                    shared_words(trial.name, still.all)};
      ++choice;
      if (best && *best >= fit) continue;
      best = fit;
      pairs[i] = {k, by_name ? person_name(recording, trial, still.whose) : "", 0};
    }
    if (pairs[i]) pairs[i]->candidate_count = choice;
  }
  return pairs;
}

}  // namespace morphe::imports
