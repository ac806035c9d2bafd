#include "stages/import/folders/static_pairing.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <tuple>

#include "stages/import/recording/name_words.hpp"

namespace morphe::imports {
namespace {

using NameWords = std::vector<NameWord>;

constexpr std::size_t kLeastShared = 3;

struct TrialPlace {
  std::vector<NameWords> folders;
  NameWords name;
};

struct StaticPlace {
  std::vector<NameWords> home;  ///< the folders that it serves
  NameWords whose;              ///< of its name, as far as it names recordings
  NameWords claimed;            ///< all that could be somebody's name
  NameWords all;                ///< every word of its name
  bool named = false;           ///< its name is somebody's
};

bool begins_with(const NameWords& words, std::span<const NameWord> beginning) {
  return words.size() >= beginning.size() &&
         std::ranges::equal(std::span(words).first(beginning.size()), beginning);
}

/// How the recording bears that name: its own begins with it and goes on, or a folder has it.
bool bears(const TrialPlace& trial, std::span<const NameWord> whose) {
  if (whose.empty()) return false;
  if (trial.name.size() > whose.size() && begins_with(trial.name, whose)) return true;
  return std::ranges::any_of(
      trial.folders, [&](const NameWords& folder) { return std::ranges::equal(folder, whose); });
}

/// The same letters and another number: ADL001 and ADL002.
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

bool is_of_another(const TrialPlace& trial, const StaticPlace& still) {
  const NameWords& claimed = still.claimed;
  if (claimed.empty()) return false;
  if (trial.name.size() > claimed.size() &&
      differs_in_number(std::span(trial.name).first(claimed.size()), claimed)) {
    return true;
  }
  return std::ranges::any_of(
      trial.folders, [&](const NameWords& folder) { return differs_in_number(folder, claimed); });
}

/// Whether the folders of `home` are among the recording's, in their order.
bool lies_below(const TrialPlace& trial, const std::vector<NameWords>& home) {
  std::size_t found = 0;
  for (const NameWords& folder : trial.folders) {
    if (found < home.size() && folder == home[found]) ++found;
  }
  return found == home.size();
}

TrialPlace place_recording(const RecordingSketch& sketch) {
  TrialPlace place;
  for (const std::string& folder : sketch.folders) place.folders.push_back(words_of(folder));
  place.name = words_of(sketch.stem);
  return place;
}

/// The longest beginning of what it claims that recordings bear: "P01 right" serves P01's. Without
/// the number in it, a name would be anybody's.
void find_whose(StaticPlace& still, const std::vector<TrialPlace>& trials) {
  const bool has_number = std::ranges::any_of(still.claimed, &NameWord::number);
  for (std::size_t length = still.claimed.size(); length > 0; --length) {
    const auto beginning = std::span(still.claimed).first(length);
    if (length < still.claimed.size() && has_number && !beginning.back().number) continue;
    if (std::ranges::any_of(trials, [&](const TrialPlace& t) { return bears(t, beginning); })) {
      still.whose.assign(beginning.begin(), beginning.end());
      still.named = true;
      return;
    }
  }
}

StaticPlace place_static(const RecordingSketch& sketch, const std::vector<TrialPlace>& trials) {
  StaticPlace still;
  for (const std::string& folder : sketch.folders) {
    if (!read_static_name(folder).is_static) still.home.push_back(words_of(folder));
  }
  still.claimed = read_static_name(sketch.stem).whose;
  still.all = words_of(sketch.stem);
  find_whose(still, trials);
  return still;
}

std::size_t shared_points(const RecordingSketch& a, const RecordingSketch& b) {
  std::vector<std::string> shared;
  std::ranges::set_intersection(a.points, b.points, std::back_inserter(shared));
  return shared.size();
}

std::size_t shared_words(const NameWords& a, const NameWords& b) {
  return static_cast<std::size_t>(std::ranges::count_if(
      a, [&](const NameWord& word) { return std::ranges::find(b, word) != b.end(); }));
}

/// "ADL001" of "ADL001DR2"; of a folder, all of it.
std::string spelled(const RecordingSketch& sketch, const TrialPlace& trial,
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
    const std::vector<RecordingSketch>& recordings, const std::vector<RecordingSketch>& statics) {
  std::vector<TrialPlace> trials;
  for (const RecordingSketch& sketch : recordings) trials.push_back(place_recording(sketch));
  std::vector<StaticPlace> places;
  for (const RecordingSketch& sketch : statics) places.push_back(place_static(sketch, trials));

  std::vector<std::optional<StaticPair>> pairs(recordings.size());
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    const RecordingSketch& recording = recordings[i];
    const TrialPlace& trial = trials[i];
    using Fit = std::tuple<std::size_t, std::size_t, bool, std::size_t, std::size_t>;
    std::optional<Fit> best;
    std::size_t choice = 0;
    for (std::size_t k = 0; k < statics.size(); ++k) {
      const StaticPlace& still = places[k];
      const bool by_name = bears(trial, still.whose);
      if (statics[k].format != recording.format || is_of_another(trial, still)) continue;
      if (still.named ? !by_name : !lies_below(trial, still.home)) continue;
      const std::size_t points = shared_points(recording, statics[k]);
      if (points < std::min(kLeastShared, recording.points.size())) continue;
      const bool below = lies_below(trial, still.home);
      // In another branch of the folders only a name with a number is trusted.
      if (!below && std::ranges::none_of(still.whose, &NameWord::number)) continue;
      const Fit fit{below ? still.home.size() + 1 : 0, by_name ? still.whose.size() : 0,
                    statics[k].subject == recording.subject, points,
                    shared_words(trial.name, still.all)};
      ++choice;
      if (best && *best >= fit) continue;
      best = fit;
      pairs[i] = {k, by_name ? spelled(recording, trial, still.whose) : "", 0};
    }
    if (pairs[i]) pairs[i]->choice = choice;
  }
  return pairs;
}

}  // namespace morphe::imports
