// Polhemus Liberty sensors and a CyberGlove II as text, with columns by name: one file each or both
// in one, and likewise for the calibration pose.
#include <fmt/format.h>

#include <algorithm>

#include "core/files/table_text.hpp"
#include "core/human/calibration.hpp"
#include "core/motion/input_error.hpp"
#include "stages/import/formats/capture_file.hpp"
#include "stages/import/formats/readers.hpp"
#include "stages/import/recording/assumption_notes.hpp"
#include "stages/import/recording/format.hpp"
#include "stages/import/trackers/add_note.hpp"

namespace morphe::imports {
namespace {

/// Reads the streams of `first` and the glove in `second`; either may be "".
Streams read_pair(const std::filesystem::path& first, const std::filesystem::path& second,
                  const RecordingFiles& files, std::vector<std::string>& used,
                  std::vector<std::string>& reports) {
  Streams streams;
  if (!first.empty()) streams = read_capture_file(first, files, used, reports);
  if (second.empty()) return streams;
  Streams glove = read_capture_file(second, files, used, reports);
  const std::string file = second.string();
  if (!glove.hand) throw InputError(file + ":1: has no column of a glove sensor");
  if (glove.sensors || glove.markers) {
    throw InputError(file +
                     ":1: has tracked bodies besides the glove; give them in the other file");
  }
  if (streams.hand)
    throw InputError(fmt::format("{}: {} already has the glove sensors", file, first.string()));
  streams.hand = std::move(glove.hand);
  return streams;
}

}  // namespace

bool recognises_liberty_csv(std::string_view head) {
  const std::string line = files::first_line_with_commas(head);
  if (!line.starts_with("time_s,") && !line.starts_with("frame,") &&
      line.find(",time_s") == std::string::npos) {
    return false;
  }
  return std::ranges::any_of(
      std::initializer_list<std::string_view>{"_qw", "_azimuth_", "ThumbRotate_", "IndexMPJ_"},
      [&](std::string_view column) { return line.find(column) != std::string::npos; });
}

Demonstration read_liberty_csv(const RecordingFiles& files) {
  Demonstration demonstration;
  std::vector<std::string>& notes = demonstration.import_notes;
  std::vector<std::string> used, calibration_notes;
  demonstration.streams = read_pair(files.file, files.glove, files, used, notes);
  demonstration.calibration =
      read_pair(files.static_trial, files.glove_static_trial, files, used, calibration_notes);
  for (const std::string& note : calibration_notes) notes.push_back("calibration pose: " + note);
  for (const auto& entry : files.name_map) {
    if (std::ranges::find(used, entry.first) == used.end()) {
      throw InputError(fmt::format("{}: names: '{}' is to be renamed but is not in the recording",
                                   files.file.string(), entry.first));
    }
  }
  if (demonstration.calibration.sensors && demonstration.streams.sensors) {
    demonstration.sensor_offsets = human::sensor_offsets(demonstration.calibration, notes);
  } else if (demonstration.streams.sensors) {
    add_note(notes, "no calibration pose: {}", kSensorsAtJoints);
  }
  if (demonstration.streams.hand && !demonstration.calibration.hand)
    add_note(notes, "no flat hand recorded: {}", kGloveZero);
  return demonstration;
}

}  // namespace morphe::imports
