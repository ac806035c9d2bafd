#include "stages/import/import.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fstream>

#include "pipeline/store/consistency.hpp"
#include "stages/import/facing.hpp"
#include "stages/import/find_recordings.hpp"
#include "stages/import/format.hpp"
#include "stages/import/import_question.hpp"
#include "stages/import/manifest.hpp"
#include "stages/import/name_map.hpp"
#include "stages/import/read_recording.hpp"
#include "stages/import/recording_sketch.hpp"

namespace morphe::imports {

const std::vector<RecordingFormat>& recording_formats() {
  static const std::vector<RecordingFormat> formats = {
      {"vicon-csv", &recognises_vicon_csv, &read_vicon_csv},
      {"trc", &recognises_trc, &read_trc},
      {"c3d", &recognises_c3d, &read_c3d},
      {"liberty-csv", &recognises_liberty_csv, &read_liberty_csv},
      {"adroit-csv", &recognises_adroit_csv, &read_adroit_csv},
      {"bvh", &recognises_bvh, &read_bvh},
      {"mot", &recognises_mot, &read_mot},
      {"qualisys-tsv", &recognises_qualisys_tsv, &read_qualisys_tsv},
      {"keypoints-csv", &recognises_keypoints_csv, &read_keypoints_csv},
      {"optitrack-csv", &recognises_optitrack_csv, &read_optitrack_csv},
      {"aria-csv", &recognises_aria_csv, &read_aria_csv},
      {"hot3d", &recognises_hot3d, &read_hot3d},
      {"mvnx", &recognises_mvnx, &read_mvnx},
      {"manus-csv", &recognises_manus_csv, &read_manus_csv},
      {"avp-jsonl", &recognises_avp_jsonl, &read_avp_jsonl},
      {"avp-npz", &recognises_avp_npz, &read_avp_npz},
      {"egodex-hdf5", &recognises_egodex_hdf5, &read_egodex_hdf5},
      {"clip-npz", &recognises_clip_npz, &read_clip_npz},
      {"point-csv", &recognises_point_csv, &read_point_csv},
  };
  return formats;
}

std::vector<std::string> import_format_names() {
  std::vector<std::string> names;
  for (const RecordingFormat& format : recording_formats()) names.push_back(format.name);
  return names;
}

namespace {

std::string head_of(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
      !std::filesystem::is_directory(status)) {
    throw InputError(fmt::format("{}: is no file: it is read more than once", file.string()));
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(status)) {
    throw InputError(fmt::format("{}: cannot be read", file.string()));
  }
  constexpr std::size_t kSeen = 65536;  // a header may name hundreds of points
  std::string head(kSeen, '\0');
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(stream.gcount()));
  return head.starts_with("\xEF\xBB\xBF") ? head.substr(3) : head;
}

const RecordingFormat& format_of(const std::string& file, const std::string& wanted) {
  const std::string known = fmt::format("{}", fmt::join(import_format_names(), ", "));
  for (const RecordingFormat& format : recording_formats()) {
    if (wanted.empty() ? format.recognises(head_of(file)) : format.name == wanted) return format;
  }
  throw InputError(wanted.empty()
                       ? fmt::format("{}:1: format: not recognised; known: {}", file, known)
                       : fmt::format("{}: format: unknown '{}'; known: {}", file, wanted, known));
}

}  // namespace

const RecordingFormat* recognised_format(const std::filesystem::path& file) {
  const std::string head = head_of(file);
  for (const RecordingFormat& format : recording_formats()) {
    if (format.recognises(head)) return &format;
  }
  return nullptr;
}

Demonstration read_recording(const ManifestEntry& entry) {
  const RecordingFormat& format = format_of(entry.file, entry.format);
  if (format.name != "liberty-csv" && !(entry.glove + entry.static_glove).empty()) {
    throw InputError(
        fmt::format("{}: glove: only liberty-csv takes one, not {}", entry.file, format.name));
  }
  Demonstration demonstration = read_or_ask(
      format,
      {entry.file, entry.static_trial, entry.glove, entry.static_glove, entry.glove_calibration,
       read_names(entry.names), side_of(entry), entry.conventions},
      entry.manifest);
  demonstration.hand = side_of(entry);
  if (entry.of_both && !shows_hand(sketch_of(demonstration), demonstration.hand)) {
    throw InputError(fmt::format("{}: hand: both, but nothing in it is called as the {} one's",
                                 entry.file, name_of(demonstration.hand)));
  }
  face_forward(entry.conventions, demonstration);
  for (const MarkerObject& object : entry.objects) {
    add_marker_object(entry.file, object, demonstration);
  }
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
  demonstration.reports.insert(demonstration.reports.end(), entry.notes.begin(), entry.notes.end());
  if (const std::string fault = store::inconsistency(demonstration); !fault.empty())
    throw InputError(fmt::format("{}: {}", entry.file, fault));
  return demonstration;
}

Imported import_recordings(const ImportRequest& request,
                           const std::function<void(Demonstration&&)>& sink) {
  FoundRecordings found = find_recordings(request);
  Imported imported;
  imported.left_out = std::move(found.left_out);
  for (ManifestEntry& entry : found.entries) {
    Demonstration demonstration;
    try {
      demonstration = read_recording(entry);
    } catch (const InputError& error) {
      if (!found.of_folder) throw;
      imported.left_out.push_back(unreadable(entry.file, error));
      continue;
    }
    sink(std::move(demonstration));
    imported.entries.push_back(std::move(entry));
  }
  expect_some(request, imported);
  return imported;
}

}  // namespace morphe::imports
