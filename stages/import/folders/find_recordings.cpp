#include "stages/import/folders/find_recordings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "stages/import/folders/dataset_files.hpp"
#include "stages/import/folders/distinct_names.hpp"
#include "stages/import/folders/entry_notes.hpp"
#include "stages/import/folders/recording_formats.hpp"
#include "stages/import/folders/static_pairing.hpp"
#include "stages/import/recording/name_words.hpp"

namespace morphe::imports {
namespace {

namespace fs = std::filesystem;

/// Moves static trials from `files` to the vector that is returned. If only static trials were
/// given directly, they are imported as recordings.
std::vector<DatasetFile> take_static_trials(std::vector<DatasetFile>& files, bool of_folder) {
  const auto is_recording = [](const DatasetFile& file) { return !is_static_trial(file); };
  if (!of_folder && std::ranges::none_of(files, is_recording)) return {};
  const auto middle = std::stable_partition(files.begin(), files.end(), is_recording);
  std::vector<DatasetFile> statics(std::make_move_iterator(middle),
                                   std::make_move_iterator(files.end()));
  files.erase(middle, files.end());
  return statics;
}

std::vector<RecordingDescriptor> sketches_of(const std::vector<DatasetFile>& files) {
  std::vector<RecordingDescriptor> sketches;
  for (const DatasetFile& file : files) sketches.push_back(file.sketch);
  return sketches;
}

ManifestEntry entry_of(const ImportRequest& request, const DatasetFile& file) {
  ManifestEntry entry;
  entry.file = file.path.string();
  entry.format = file.from_folder ? file.sketch.format : request.format;
  entry.names = file.names;
  entry.conventions = request.conventions;
  const HandSelection told =
      file.hand.side == Side::left ? HandSelection::left : HandSelection::right;
  // Some recordings of a folder may show one hand only.
  const bool two =
      has_points_of_side(file.sketch, Side::right) && has_points_of_side(file.sketch, Side::left);
  const bool as_told =
      !request.hand || (*request.hand == HandSelection::both && file.from_folder && !two);
  entry.hand = as_told ? told : *request.hand;
  const bool usual = !file.from_folder && told == HandSelection::right;
  if (as_told && !usual) entry.notes.push_back(file.hand.why);
  if (file.from_folder && has_static_name(file)) {
    entry.notes.push_back(
        fmt::format("{}, but its points move; treated as a demonstration", kMovingStaticTrial));
  }
  return entry;
}

void pair_entry(const DatasetFile& file, const std::optional<StaticPair>& pair,
                const std::vector<DatasetFile>& statics, ManifestEntry& entry) {
  if (pair) {
    const DatasetFile& still = statics[pair->static_index];
    entry.static_trial = still.path.string();
    entry.notes.push_back(fmt::format(
        "static trial: {}{}", still.display_name,
        pair->candidate_count > 1
            ? fmt::format(", chosen from {} that may be of this person", pair->candidate_count)
            : ""));
    if (!still.sketch.subject.empty() && !file.sketch.subject.empty() &&
        still.sketch.subject != file.sketch.subject) {
      entry.notes.push_back(
          fmt::format("the static trial is of subject {}, the recording of subject {}",
                      still.sketch.subject, file.sketch.subject));
    }
  } else if (file.from_folder && file.sketch.has_markers) {
    entry.notes.emplace_back(kNoStaticTrial);
  }
}

/// Returns the first folder that names a person, preferably one with a number; folders shared by
/// all recordings do not name a person.
std::string person_of(const std::vector<std::string>& folders, std::size_t shared) {
  std::string person;
  for (std::size_t k = shared; k < folders.size(); ++k) {
    if (is_generic_folder_name(folders[k]) || parse_static_name(folders[k]).is_static) continue;
    const bool numbered = std::ranges::any_of(split_name(folders[k]), &NameWord::number);
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

void add_recordings(const ImportRequest& request, std::vector<DatasetFile> files,
                    std::vector<SkippedFile>& left_out, std::vector<NamedEntry>& entries) {
  const bool given = !request.static_trial.empty();
  const bool of_folder = std::ranges::any_of(files, &DatasetFile::from_folder);
  const std::vector<DatasetFile> statics = take_static_trials(files, of_folder);
  remove_duplicates(files, left_out);
  const auto pairs = pair_static_trials(
      sketches_of(files), given ? std::vector<RecordingDescriptor>{} : sketches_of(statics));
  std::vector<std::size_t> served(statics.size());
  const std::size_t shared = shared_folders(files);
  for (std::size_t k = 0; k < files.size(); ++k) {
    const DatasetFile& file = files[k];
    ManifestEntry entry = entry_of(request, file);
    if (!given) {
      pair_entry(file, pairs[k], statics, entry);
    } else if (!file.from_folder || file.sketch.has_markers) {
      entry.static_trial = request.static_trial.string();
    }
    if (pairs[k]) ++served[pairs[k]->static_index];
    if (file.from_folder) {
      entry.subject = pairs[k] ? pairs[k]->person : "";
      if (entry.subject.empty()) entry.subject = person_of(file.sketch.folders, shared);
    }
    for (ManifestEntry& one : split_by_hand(std::move(entry))) {
      std::vector<std::string> names = candidate_names(file);
      if (one.split_from_both) {
        for (std::string& name : names) name += fmt::format("_{}", name_of(side_of(one)));
      }
      entries.push_back({std::move(one), std::move(names), file.request_index});
    }
  }
  for (std::size_t k = 0; k < statics.size(); ++k) {
    left_out.push_back({statics[k].path, served[k] > 0 || given
                                             ? "static trial"
                                             : "static trial without a matching recording"});
  }
}

}  // namespace

FoundRecordings find_recordings(const ImportRequest& request) {
  FoundRecordings found;
  std::vector<NamedEntry> entries;
  std::vector<DatasetFile> files = dataset_files(request, entries, found.left_out);
  found.from_folder = std::ranges::any_of(
      request.paths, [](const fs::path& path) { return fs::is_directory(path); });
  add_recordings(request, std::move(files), found.left_out, entries);
  std::ranges::stable_sort(entries, {}, &NamedEntry::request_index);
  found.entries = assign_unique_names(std::move(entries));
  return found;
}

void require_recordings(const ImportRequest& request, const ImportResult& imported) {
  const auto folder = std::ranges::find_if(
      request.paths, [](const fs::path& path) { return fs::is_directory(path); });
  if (!imported.entries.empty() || folder == request.paths.end()) return;
  std::map<std::string, std::size_t> reasons;
  std::vector<std::string> list;
  for (const SkippedFile& one : imported.skipped) {
    if (one.failed) {
      const std::size_t line = std::min(one.reason.find('\n'), one.reason.size());
      throw InputError(skip_message(one) + one.reason.substr(line));
    }
    ++reasons[one.reason];
  }
  for (const auto& [why, count] : reasons) list.push_back(fmt::format("{} {}", count, why));
  throw InputError(fmt::format("{}: no recording found ({}); known formats: {}", folder->string(),
                               list.empty() ? "no files" : fmt::format("{}", fmt::join(list, "; ")),
                               fmt::join(import_format_names(), ", ")));
}

}  // namespace morphe::imports
