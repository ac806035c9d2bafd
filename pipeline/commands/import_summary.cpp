#include "pipeline/commands/import_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string_view>
#include <vector>

#include "core/files/atomic_file.hpp"
#include "core/files/sha256.hpp"
#include "core/motion/count_with_noun.hpp"
#include "core/motion/input_error.hpp"
#include "core/store/hdf5_signature.hpp"
#include "pipeline/commands/import_question_text.hpp"
#include "stages/import/folders/manifest.hpp"
#include "stages/import/folders/read_recording.hpp"
#include "stages/import/recording/assumption_notes.hpp"

namespace morphe::commands {
namespace {

namespace fs = std::filesystem;
using imports::ImportResult;
using imports::SkippedFile;

constexpr std::string_view kHashLinePrefix = "# morphe ";
constexpr int kMaxLinesPerReason = 8, kShownLinesPerReason = 3;

const char* what_happened(const SkippedFile& file) {
  return file.failed ? "cannot be read" : "skipped";
}

std::string skipped_text(const std::vector<SkippedFile>& skipped) {
  std::map<std::string, int> count, shown;
  const auto first_line = [](const SkippedFile& file) {
    return file.reason.substr(0, file.reason.find('\n'));
  };
  for (const SkippedFile& file : skipped) ++count[first_line(file)];
  std::string text;
  for (const SkippedFile& file : skipped) {
    const std::string reason = first_line(file);
    const int files = count[reason];
    if (files > kMaxLinesPerReason && shown[reason] == kShownLinesPerReason) continue;
    text += fmt::format("{}: {}\n", what_happened(file), skip_message(file));
    if (++shown[reason] == kShownLinesPerReason && files > kMaxLinesPerReason)
      text += fmt::format("{}: {} more: {}\n", what_happened(file), files - kShownLinesPerReason,
                          reason);
  }
  return text;
}

/// Returns a line per subject: its number of recordings with a note that starts so, and `meaning`.
std::string notes_by_subject_text(const ImportResult& imported, std::string_view beginning,
                                  const char* meaning) {
  std::map<std::string, int> recordings;
  for (const imports::ManifestEntry& entry : imported.entries) {
    if (std::ranges::any_of(entry.notes,
                            [&](const std::string& note) { return note.starts_with(beginning); }))
      ++recordings[entry.subject];
  }
  std::string text;
  for (const auto& [subject, count] : recordings)
    text += fmt::format("note: {}{}: {}\n", subject.empty() ? "" : subject + ": ",
                        count_with_noun(count, "recording"), meaning);
  return text;
}

std::string summary_line(const ImportResult& imported) {
  std::size_t with_static = 0, left_handed = 0;
  std::set<std::string> people;
  for (const imports::ManifestEntry& entry : imported.entries) {
    with_static += entry.static_trial.empty() ? 0U : 1U;
    left_handed += entry.hand == imports::HandSelection::left ? 1U : 0U;
    if (!entry.subject.empty()) people.insert(entry.subject);
  }
  const std::size_t recordings = imported.entries.size();
  return fmt::format("found: {}{}, {} with a static trial; right hand {}, left hand {}\n",
                     count_with_noun(recordings, "recording"),
                     people.empty()       ? ""
                     : people.size() == 1 ? " of 1 person"
                                          : fmt::format(" of {} people", people.size()),
                     with_static, recordings - left_handed, left_handed);
}

std::string read_all(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string hash_line(std::string_view body) {
  return fmt::format(
      "{}{} is the SHA-256 of the lines below; if they are edited, this file is not replaced\n",
      kHashLinePrefix, files::sha256(body));
}

}  // namespace

bool is_demonstrations_file(const fs::path& file) {
  if (!store::has_hdf5_signature(file)) return file.extension() == ".h5";
  return imports::recognised_format(file) == nullptr;
}

std::string import_summary_text(const ImportResult& imported) {
  if (imported.skipped.empty() &&
      std::ranges::all_of(imported.entries, [](const auto& entry) { return entry.notes.empty(); }))
    return "";
  return summary_line(imported) +
         notes_by_subject_text(imported, imports::kNoStaticTrial,
                               "no static trial found: joint centres may be wrong by centimetres") +
         notes_by_subject_text(imported, imports::kRightHandAssumed,
                               "reaching hand not in the file: assumed right") +
         notes_by_subject_text(
             imported, imports::kMovingStaticTrial,
             "named as a static trial, but the person moves: used as a demonstration") +
         skipped_text(imported.skipped) + skipped_questions_text(imported.skipped) +
         (count_failed(imported) > 0
              ? "morphe inspect FILE shows what such a file contains and what is missing\n"
              : "");
}

int count_failed(const ImportResult& imported) {
  int count = 0;
  for (const SkippedFile& file : imported.skipped) count += file.failed ? 1 : 0;
  return count;
}

void GeneratedManifest::expect_replaceable() const {
  std::error_code error;
  if (!fs::exists(file_, error)) return;
  const std::string text = read_all(file_);
  const std::size_t end = text.find('\n');
  if (end != std::string::npos && text.substr(0, end + 1) == hash_line(text.substr(end + 1)))
    return;
  throw InputError(
      fmt::format("{}: would be replaced, but was edited or not written by Morphe: use it as the "
                  "dataset, or move it elsewhere",
                  file_.string()));
}

std::string GeneratedManifest::lines(const ImportResult& imported) const {
  std::string body =
      "# The recordings that were found. To change the list, edit this file and use it as the "
      "dataset;\n"
      "# paths are relative to it. Notes list the assumptions, and are stored with the plans.\n";
  const fs::path folder = file_.parent_path().empty() ? fs::path(".") : file_.parent_path();
  for (const SkippedFile& file : imported.skipped) {
    std::string line = fmt::format("# {}: {}", what_happened(file), skip_message(file));
    std::ranges::replace_if(
        line, [](char c) { return static_cast<unsigned char>(c) < ' '; }, '?');
    body += line + "\n";
  }
  return body + imports::manifest_text(imported.entries, folder);
}

void GeneratedManifest::write(const std::string& lines) const {
  files::write_atomically(file_, hash_line(lines) + lines);
}

}  // namespace morphe::commands
