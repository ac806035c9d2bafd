#include "stages/import/folders/find_recordings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "stages/import/folders/dataset_files.hpp"
#include "stages/import/folders/distinct_names.hpp"
#include "stages/import/folders/recording_formats.hpp"
#include "stages/import/folders/static_pairing.hpp"
#include "stages/import/recording/name_words.hpp"

namespace morphe::imports {
namespace {

namespace fs = std::filesystem;

/// Static trials out of `files`, into the vector that is returned. Where nothing else was given
/// directly, that is what is meant.
std::vector<DatasetFile> take_static_trials(std::vector<DatasetFile>& files, bool of_folder) {
  const auto is_recording = [](const DatasetFile& file) { return !is_static_trial(file); };
  if (!of_folder && std::ranges::none_of(files, is_recording)) return {};
  const auto middle = std::stable_partition(files.begin(), files.end(), is_recording);
  std::vector<DatasetFile> statics(std::make_move_iterator(middle),
                                   std::make_move_iterator(files.end()));
  files.erase(middle, files.end());
  return statics;
}

std::vector<RecordingSketch> sketches_of(const std::vector<DatasetFile>& files) {
  std::vector<RecordingSketch> sketches;
  for (const DatasetFile& file : files) sketches.push_back(file.sketch);
  return sketches;
}

ManifestEntry entry_of(const ImportRequest& request, const DatasetFile& file) {
  ManifestEntry entry;
  entry.file = file.path.string();
  entry.format = file.in_folder ? file.sketch.format : request.format;
  entry.names = file.names;
  entry.conventions = request.conventions;
  const Hands told = file.hand.side == Side::left ? Hands::left : Hands::right;
  // Of a folder's recordings some may be of one hand alone.
  const bool two = shows_hand(file.sketch, Side::right) && shows_hand(file.sketch, Side::left);
  const bool as_told = !request.hand || (*request.hand == Hands::both && file.in_folder && !two);
  entry.hand = as_told ? told : *request.hand;
  const bool usual = !file.in_folder && told == Hands::right;
  if (as_told && !usual) entry.notes.push_back(file.hand.why);
  if (file.in_folder && named_as_static(file)) {
    entry.notes.push_back(
        "its name is that of a static trial, but its points move: taken as a "
        "demonstration");
  }
  return entry;
}

void pair_entry(const DatasetFile& file, const std::optional<StaticPair>& pair,
                const std::vector<DatasetFile>& statics, ManifestEntry& entry) {
  if (pair) {
    const DatasetFile& still = statics[pair->which];
    entry.static_trial = still.path.string();
    entry.notes.push_back(fmt::format(
        "static trial: {}{}", still.called,
        pair->choice > 1 ? fmt::format(", of {} that may be its person's", pair->choice) : ""));
    if (!still.sketch.subject.empty() && !file.sketch.subject.empty() &&
        still.sketch.subject != file.sketch.subject) {
      entry.notes.push_back(
          fmt::format("the static trial's file says subject {}, the recording's {}",
                      still.sketch.subject, file.sketch.subject));
    }
  } else if (file.in_folder && file.sketch.markers) {
    entry.notes.push_back("no static trial was found for it");
  }
}

/// The first folder that names somebody, one with a number rather than one without; folders that
/// all recordings share name nobody.
std::string person_of(const std::vector<std::string>& folders, std::size_t shared) {
  std::string person;
  for (std::size_t k = shared; k < folders.size(); ++k) {
    if (names_nobody(folders[k]) || read_static_name(folders[k]).is_static) continue;
    const bool numbered = std::ranges::any_of(words_of(folders[k]), &NameWord::number);
    if (numbered) return folders[k];
    if (person.empty()) person = folders[k];
  }
  return person;
}

std::size_t shared_folders(const std::vector<DatasetFile>& files) {
  std::size_t shared = files.empty() ? 0 : files.front().sketch.folders.size();
  for (const DatasetFile& file : files) {
    const auto& first = files.front().sketch.folders;
    const auto& other = file.sketch.folders;
    const auto differ = std::ranges::mismatch(first, other).in1;
    shared = std::min(shared, static_cast<std::size_t>(differ - first.begin()));
  }
  return shared;
}

void add_found(const ImportRequest& request, std::vector<DatasetFile> files,
               std::vector<LeftOut>& left_out, std::vector<NamedEntry>& entries) {
  const bool given = !request.static_trial.empty();
  const bool of_folder = std::ranges::any_of(files, &DatasetFile::in_folder);
  const std::vector<DatasetFile> statics = take_static_trials(files, of_folder);
  leave_out_doubles(files, left_out);
  const auto pairs = pair_static_trials(
      sketches_of(files), given ? std::vector<RecordingSketch>{} : sketches_of(statics));
  std::vector<std::size_t> served(statics.size());
  const std::size_t shared = shared_folders(files);
  for (std::size_t k = 0; k < files.size(); ++k) {
    const DatasetFile& file = files[k];
    ManifestEntry entry = entry_of(request, file);
    if (!given) {
      pair_entry(file, pairs[k], statics, entry);
    } else if (!file.in_folder || file.sketch.markers) {
      entry.static_trial = request.static_trial.string();
    }
    if (pairs[k]) ++served[pairs[k]->which];
    if (file.in_folder) {
      entry.subject = pairs[k] ? pairs[k]->person : "";
      if (entry.subject.empty()) entry.subject = person_of(file.sketch.folders, shared);
    }
    for (ManifestEntry& one : hand_by_hand(std::move(entry))) {
      std::vector<std::string> names = names_for(file);
      if (one.of_both) {
        for (std::string& name : names) name += fmt::format("_{}", name_of(side_of(one)));
      }
      entries.push_back({std::move(one), std::move(names), file.given});
    }
  }
  for (std::size_t k = 0; k < statics.size(); ++k) {
    left_out.push_back({statics[k].path, served[k] > 0 || given
                                             ? "static trial"
                                             : "static trial, but of no recording that was found"});
  }
}

}  // namespace

FoundRecordings find_recordings(const ImportRequest& request) {
  FoundRecordings found;
  std::vector<NamedEntry> entries;
  std::vector<DatasetFile> files = dataset_files(request, entries, found.left_out);
  found.of_folder = std::ranges::any_of(
      request.paths, [](const fs::path& path) { return fs::is_directory(path); });
  add_found(request, std::move(files), found.left_out, entries);
  std::ranges::stable_sort(entries, {}, &NamedEntry::path);
  found.entries = give_names(std::move(entries));
  return found;
}

void expect_some(const ImportRequest& request, const Imported& imported) {
  const auto folder = std::ranges::find_if(
      request.paths, [](const fs::path& path) { return fs::is_directory(path); });
  if (!imported.entries.empty() || folder == request.paths.end()) return;
  std::map<std::string, std::size_t> reasons;
  std::vector<std::string> list;
  for (const LeftOut& one : imported.left_out) {
    if (one.failed) {
      const std::size_t line = std::min(one.why.find('\n'), one.why.size());
      throw InputError(sentence_of(one) + one.why.substr(line));
    }
    ++reasons[one.why];
  }
  for (const auto& [why, count] : reasons) list.push_back(fmt::format("{} {}", count, why));
  throw InputError(fmt::format("{}: holds no recording ({}); formats: {}", folder->string(),
                               list.empty() ? "no file" : fmt::format("{}", fmt::join(list, "; ")),
                               fmt::join(import_format_names(), ", ")));
}

}  // namespace morphe::imports
