#include "stages/import/folders/read_recording.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <system_error>

#include "core/files/file_kind.hpp"
#include "core/store/consistency.hpp"
#include "stages/import/audit/audit.hpp"
#include "stages/import/folders/audit_answer.hpp"
#include "stages/import/folders/recording_descriptor.hpp"
#include "stages/import/folders/recording_formats.hpp"
#include "stages/import/guess/heading.hpp"
#include "stages/import/guess/name_map.hpp"
#include "stages/import/guess/unresolved_import.hpp"
#include "stages/import/recording/assumption_notes.hpp"

namespace morphe::imports {
namespace {

[[noreturn]] void throw_foreign(const std::string& file, const files::FileKind& kind) {
  throw InputError(fmt::format("{}: is {}; {}", file, kind.name,
                               kind.advice.empty() ? "give the recording itself" : kind.advice));
}

const RecordingFormat& format_of(const std::string& file, const std::string& name) {
  const auto named = std::ranges::find(recording_formats(), name, &RecordingFormat::name);
  if (named != recording_formats().end()) return *named;
  const RecordingFormat* const recognised = name.empty() ? recognised_format(file) : nullptr;
  if (recognised) return *recognised;
  if (const auto kind = files::file_kind(files::read_file_head(file)); kind && name.empty())
    throw_foreign(file, *kind);
  const std::string known = fmt::format("{}", fmt::join(import_format_names(), ", "));
  throw InputError(name.empty()
                       ? fmt::format("{}:1: format: not recognised; known: {}", file, known)
                       : fmt::format("{}: format: unknown '{}'; known: {}", file, name, known));
}

/// Audits a recording. Throws UnresolvedImport for a doubt that the user must answer.
void question_recording(const RecordingFormat& format, const RecordingFiles& files,
                        const ManifestEntry& entry, Demonstration& demonstration) {
  const Conventions& given = entry.conventions;
  const AuditInput input{
      .file = entry.file,
      .axes_given = !given.axes.empty(),
      .unit_given = !given.unit.empty(),
      .rate_given = given.rate_hz.has_value(),
      .hand_given = entry.hand.has_value(),
      .accepted = entry.accept,
      .answer = [&](const Doubt& doubt) { return tested_answer(format, files, doubt); }};
  const std::optional<Doubt> doubt = audit_recording(input, demonstration);
  if (!doubt) return;
  UnresolvedImport question(
      fmt::format("{}: {}: {}", entry.file, doubt->question->key, doubt->flag.text));
  question.file = entry.file;
  question.manifest = entry.manifest;
  const std::string& reason =
      doubt->question->reason.empty() ? doubt->flag.text : doubt->question->reason;
  question.static_trial = entry.static_trial;
  question.given = entry.conventions;
  if (side_of(entry) == Side::left) question.hand = Side::left;
  question.proposal.conventions.emplace_back(
      doubt->question->key, Guess{doubt->question->value, doubt->question->confidence, reason});
  throw question;
}

}  // namespace

const RecordingFormat* recognised_format(const std::filesystem::path& file) {
  const std::string head = files::read_file_head(file);
  const std::optional<files::FileKind> kind = files::file_kind(head);
  if (kind && kind->pointer) throw_foreign(file.string(), *kind);  // in a folder, it is missed
  // A binary file of a known kind is not looked at by the formats: an .xlsx is a zip as an .npz is.
  if (kind && head.find('\0') != head.npos) return nullptr;
  const auto format = std::ranges::find_if(
      recording_formats(), [&](const RecordingFormat& known) { return known.recognises(head); });
  return format == recording_formats().end() ? nullptr : &*format;
}

Demonstration read_recording(const ManifestEntry& entry, bool questioned) {
  const RecordingFormat& format = format_of(entry.file, entry.format);
  if (format.name != "liberty-csv" && !(entry.glove + entry.glove_static_trial).empty()) {
    throw InputError(fmt::format("{}: glove: is only possible with the format liberty-csv, not {}",
                                 entry.file, format.name));
  }
  const RecordingFiles files{entry.file,
                             entry.static_trial,
                             entry.glove,
                             entry.glove_static_trial,
                             entry.glove_calibration,
                             read_names(entry.names),
                             side_of(entry),
                             entry.conventions};
  Demonstration demonstration = read_or_propose(format, files, entry.manifest);
  demonstration.hand = side_of(entry);
  if (entry.split_from_both &&
      !has_points_of_side(recording_descriptor(demonstration), demonstration.hand)) {
    throw InputError(fmt::format("{}: hand: is both, but no point name belongs to the {} hand",
                                 entry.file, name_of(demonstration.hand)));
  }
  for (const FlagCode code : entry.accept) demonstration.accepted_flags.push_back({code});
  if (questioned) question_recording(format, files, entry, demonstration);
  align_heading(entry.conventions, demonstration);
  for (const MarkerObject& object : entry.objects)
    add_marker_object(entry.file, object, demonstration);
  demonstration.name = entry.name;
  if (!entry.subject.empty()) demonstration.subject = entry.subject;
  if (!entry.task.empty()) demonstration.task = entry.task;
  if (!entry.source.empty()) demonstration.source = entry.source;
  if (!entry.licence.empty()) demonstration.licence = entry.licence;
  if (entry.upper_arm) demonstration.upper_arm = entry.upper_arm;
  if (entry.forearm) demonstration.forearm = entry.forearm;
  if (entry.hand_length) demonstration.hand_length = entry.hand_length;
  if (entry.hand_breadth) demonstration.hand_breadth = entry.hand_breadth;
  if (!entry.labels.empty()) demonstration.labels = entry.labels;
  demonstration.import_notes.insert(demonstration.import_notes.end(), entry.notes.begin(),
                                    entry.notes.end());
  demonstration.assumptions = assumptions_in(demonstration.import_notes);
  if (const std::string error = store::inconsistency(demonstration); !error.empty())
    throw InputError(fmt::format("{}: {}", entry.file, error));
  return demonstration;
}

}  // namespace morphe::imports
