#include "stages/import/folders/find_recordings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <span>

#include "core/config/error_list.hpp"
#include "stages/import/folders/dataset_files.hpp"
#include "stages/import/folders/distinct_names.hpp"
#include "stages/import/folders/given_options.hpp"
#include "stages/import/folders/manifest.hpp"
#include "stages/import/folders/recording_formats.hpp"
#include "stages/import/folders/static_pairing.hpp"
#include "stages/import/recording/assumption_notes.hpp"
#include "stages/import/recording/name_words.hpp"

namespace morphe::imports {
namespace {

namespace fs = std::filesystem;

auto first_folder(const ImportRequest& request) {
  return std::ranges::find_if(request.paths,
                              [](const fs::path& path) { return fs::is_directory(path); });
}

/// Removes the static trials from `files` and returns them. If there is no other file and no folder
/// (`of_folder`), they stay and are imported as recordings.
std::vector<DatasetFile> take_static_trials(std::vector<DatasetFile>& files, bool of_folder) {
  const auto is_recording = [](const DatasetFile& file) { return !is_static_trial(file); };
  if (!of_folder && std::ranges::none_of(files, is_recording)) return {};
  const auto first_static = std::stable_partition(files.begin(), files.end(), is_recording);
  std::vector<DatasetFile> statics(std::make_move_iterator(first_static),
                                   std::make_move_iterator(files.end()));
  files.erase(first_static, files.end());
  return statics;
}

std::vector<RecordingDescriptor> descriptors_of(const std::vector<DatasetFile>& files) {
  std::vector<RecordingDescriptor> descriptors;
  for (const DatasetFile& file : files) descriptors.push_back(file.descriptor);
  return descriptors;
}

ManifestEntry entry_of(const ImportRequest& request, const DatasetFile& file) {
  ManifestEntry entry;
  entry.file = file.path.string();
  entry.format = file.from_folder ? file.descriptor.format : request.format;
  entry.names = file.names;
  entry.conventions = request.conventions;
  const HandSelection reaching =
      file.hand.side == Side::left ? HandSelection::left : HandSelection::right;
  // If both hands of a folder's recordings are requested, some may show one hand only.
  const bool two_hands = has_points_of_side(file.descriptor, Side::right) &&
                         has_points_of_side(file.descriptor, Side::left);
  const bool use_reaching =
      !request.hand || (*request.hand == HandSelection::both && file.from_folder && !two_hands);
  entry.hand = use_reaching ? reaching : *request.hand;
  const bool expected = !file.from_folder && reaching == HandSelection::right;
  if (use_reaching && !expected) entry.notes.push_back(file.hand.reason);
  if (file.from_folder && has_static_name(file)) {
    entry.notes.push_back(
        fmt::format("{}, but its points move; treated as a demonstration", kMovingStaticTrial));
  }
  return entry;
}

void pair_entry(const DatasetFile& file, const std::optional<StaticPair>& pair,
                const std::vector<DatasetFile>& statics, ManifestEntry& entry) {
  if (pair) {
    const DatasetFile& static_trial = statics[pair->static_index];
    const std::string& subject = static_trial.descriptor.subject;
    entry.static_trial = static_trial.path.string();
    entry.notes.push_back(fmt::format("static trial: {}{}", static_trial.display_name,
                                      pair->candidate_count > 1
                                          ? fmt::format("{} {} that may be of this person",
                                                        kStaticTrialChosen, pair->candidate_count)
                                          : ""));
    if (!subject.empty() && !file.descriptor.subject.empty() &&
        subject != file.descriptor.subject) {
      entry.notes.push_back(
          fmt::format("the static trial is of subject {}, the recording of subject {}", subject,
                      file.descriptor.subject));
    }
  } else if (file.from_folder && file.descriptor.has_markers) {
    entry.notes.emplace_back(kNoStaticTrial);
  }
}

/// Returns the first folder that names a person, preferably one with a number. The first
/// `shared_count` folders, which all recordings have in common, do not name a person.
std::string person_of(const std::vector<std::string>& folders, std::ptrdiff_t shared_count) {
  std::string person;
  for (const std::string& folder : std::span(folders).subspan(shared_count)) {
    if (is_generic_folder_name(folder) || parse_static_name(folder).is_static) continue;
    if (std::ranges::any_of(split_name(folder), &NameWord::number)) return folder;
    if (person.empty()) person = folder;
  }
  return person;
}

std::ptrdiff_t shared_folder_count(const std::vector<DatasetFile>& files) {
  if (files.empty()) return 0;
  const std::vector<std::string>& first = files.front().descriptor.folders;
  std::ptrdiff_t shared = std::ssize(first);
  for (const DatasetFile& file : files) {
    const auto differing = std::ranges::mismatch(first, file.descriptor.folders).in1;
    shared = std::min(shared, differing - first.begin());
  }
  return shared;
}

/// Adds to `contents.entries` one entry, or one for each hand, for each recording among its files.
void add_entries(const ImportRequest& request, DatasetContents& contents) {
  auto& [entries, files, left_out] = contents;
  const bool given = !request.static_trial.empty();  // one static trial for all recordings
  const bool of_folder = std::ranges::any_of(files, &DatasetFile::from_folder);
  const std::vector<DatasetFile> statics = take_static_trials(files, of_folder);
  remove_duplicates(files, left_out);
  const auto pairs = pair_static_trials(
      descriptors_of(files), given ? std::vector<RecordingDescriptor>{} : descriptors_of(statics));
  std::vector<bool> used(statics.size());
  const std::ptrdiff_t shared_count = shared_folder_count(files);
  for (int k = 0; k < std::ssize(files); ++k) {
    const DatasetFile& file = files[k];
    ManifestEntry entry = entry_of(request, file);
    if (!given) {
      pair_entry(file, pairs[k], statics, entry);
    } else if (!file.from_folder || file.descriptor.has_markers) {
      entry.static_trial = request.static_trial.string();
    }
    if (pairs[k]) used[pairs[k]->static_index] = true;
    if (file.from_folder) {
      entry.subject = pairs[k] ? pairs[k]->person : "";
      if (entry.subject.empty()) entry.subject = person_of(file.descriptor.folders, shared_count);
    }
    for (ManifestEntry& split : split_by_hand(std::move(entry))) {
      std::vector<std::string> names = candidate_names(file);
      if (split.split_from_both) {
        for (std::string& name : names) name += fmt::format("_{}", name_of(side_of(split)));
      }
      entries.push_back({std::move(split), std::move(names), file.request_index});
    }
  }
  for (int k = 0; k < std::ssize(statics); ++k) {
    left_out.push_back({statics[k].path, used[k] || given
                                             ? "static trial"
                                             : "static trial without a matching recording"});
  }
}

}  // namespace

FoundRecordings find_recordings(const ImportRequest& request) {
  DatasetContents contents = dataset_files(request);
  expect_effect_of_options(request, contents);
  add_entries(request, contents);
  std::ranges::stable_sort(contents.entries, {}, &NamedEntry::request_index);
  return {assign_unique_names(std::move(contents.entries)), std::move(contents.left_out),
          first_folder(request) != request.paths.end()};
}

namespace {

/// Throws one error with those of all files that failed, as the question of the first that has one.
void throw_failures(const std::vector<SkippedFile>& skipped) {
  config::ErrorList errors;
  const UnresolvedImport* question = nullptr;
  for (const SkippedFile& file : skipped) {
    if (!file.failed) continue;
    if (question == nullptr) question = file.question.get();
    const std::size_t second_line = std::min(file.reason.find('\n'), file.reason.size());
    errors.add(skip_message(file) + file.reason.substr(second_line));
  }
  try {
    errors.throw_if_any();
  } catch (const InputError& error) {
    if (question == nullptr) throw;
    throw question->with_message(error.what());
  }
}

}  // namespace

void require_recordings(const ImportRequest& request, const ImportResult& imported) {
  if (!imported.entries.empty()) return;
  throw_failures(imported.skipped);
  const auto folder = first_folder(request);
  if (folder == request.paths.end()) return;
  std::map<std::string, int> counts;  // by reason
  for (const SkippedFile& file : imported.skipped) ++counts[file.reason];
  std::string reasons;
  for (const auto& [reason, count] : counts)
    reasons += fmt::format("{}{} {}", reasons.empty() ? "" : "; ", count, reason);
  throw InputError(fmt::format("{}: no recording found ({}); known formats: {}", folder->string(),
                               reasons.empty() ? "no files" : reasons,
                               fmt::join(import_format_names(), ", ")));
}

}  // namespace morphe::imports
