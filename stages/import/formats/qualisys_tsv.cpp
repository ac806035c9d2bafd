// Qualisys Track Manager's TSV: a line per key (NO_OF_FRAMES, NO_OF_MARKERS, FREQUENCY,
// MARKER_NAMES, …), optionally a line with column names, then a row per frame: x, y and z of each
// marker, optionally after the frame's number and its time. A marker at 0, 0, 0 or with empty cells
// was not seen. Lengths are always in millimetres. The file does not contain its axes.
#include <fmt/format.h>

#include <map>

#include "core/files/table_text.hpp"
#include "stages/import/formats/marker_columns.hpp"
#include "stages/import/formats/marker_recording.hpp"
#include "stages/import/formats/readers.hpp"
#include "stages/import/recording/assumption_notes.hpp"
#include "stages/import/recording/repeated_names.hpp"
#include "stages/import/trackers/add_note.hpp"
#include "stages/import/trackers/hand_tracker.hpp"

namespace morphe::imports {
namespace {

constexpr std::string_view kMarkerNames = "MARKER_NAMES";

struct TsvHeader {
  std::map<std::string, std::pair<std::size_t, std::string>> value;  ///< by key: line, first value
  std::vector<std::string> markers;
  std::size_t names_line = 0, first_row = 0;
  bool first_column_is_time = false;  ///< otherwise a leading column has the frame number
};

bool is_key(std::string_view word) {
  return !word.empty() &&
         word.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789") ==
             std::string_view::npos &&
         word.find_first_not_of("0123456789") != std::string_view::npos;
}

TsvHeader read_tsv_header(const files::CsvText& text) {
  TsvHeader header;
  std::size_t line = text.filled_line(1);
  for (; line <= text.lines.size(); ++line) {
    const auto cells = text.cells(line);
    if (!is_key(cells[0])) break;
    header.value.emplace(cells[0], std::pair(line, std::string(cells.size() > 1 ? cells[1] : "")));
    if (cells[0] != kMarkerNames) continue;
    if (header.names_line > 0) text.fail(line, kMarkerNames, "appears twice");
    header.names_line = line;
    for (std::size_t c = 1; c < cells.size(); ++c) header.markers.emplace_back(cells[c]);
    while (!header.markers.empty() && header.markers.back().empty()) header.markers.pop_back();
  }
  if (header.markers.empty())
    text.fail(std::max<std::size_t>(1, header.names_line), kMarkerNames, "has no marker names");
  for (const std::string& name : header.markers) {
    if (name.empty()) text.fail(header.names_line, kMarkerNames, "a marker has no name");
  }
  // An optional line names the columns: "Frame Time A X A Y A Z", or "A X …" for a marker A.
  line = text.filled_line(line);
  if (line <= text.lines.size() && !text.value(text.cells(line)[0])) {
    header.first_column_is_time = text.cells(line)[0] == "Time";
    ++line;
  }
  if (line > text.lines.size()) text.fail(text.lines.size(), "", "ends before the first frame");
  header.first_row = line;
  return header;
}

double number_in_header(const files::CsvText& text, const TsvHeader& header,
                        const std::string& key) {
  const auto found = header.value.find(key);
  if (found == header.value.end() || found->second.second.empty()) return 0;
  return text.number(found->second.first, key, found->second.second);
}

/// Returns the number of columns before the first marker's: 0, 1 or 2.
std::size_t leading_columns(const files::CsvText& text, const TsvHeader& header) {
  std::size_t cells = text.cells(header.first_row).size();
  const std::size_t points = 3 * header.markers.size();
  if (cells > points + 2 && text.cells(header.first_row).back().empty()) --cells;
  if (cells < points || cells > points + 2) {
    text.fail(
        header.first_row, "",
        fmt::format("the row has {} cells; {} markers need {}, or two more with frame and time",
                    cells, header.markers.size(), points));
  }
  return cells - points;
}

void read_frames_of(const files::CsvText& text, const TsvHeader& header, double metres,
                    double rate_hz, MarkerRecording& recording) {
  const std::size_t leading = leading_columns(text, header), markers = header.markers.size();
  MarkerStream& stream = recording.markers;
  stream.position = {text.lines.size() - header.first_row + 1, markers, unknown_point()};
  double first_frame = 0;
  for (std::size_t line = header.first_row; line <= text.lines.size(); ++line) {
    const std::size_t row = line - header.first_row;
    const auto cells = text.cells(line);
    if (cells.size() < leading + 3 * markers) {
      text.fail(line,
                header.markers[(cells.size() - std::min(cells.size(), leading)) / 3 % markers],
                fmt::format("the row has {} cells, not {}", cells.size(), leading + 3 * markers));
    }
    double frame = static_cast<double>(row);
    if (leading > 0 && !header.first_column_is_time) {
      frame = text.number(line, "Frame", cells[0]);
      if (row == 0) first_frame = frame;
      frame -= first_frame;
    }
    add_time(frame / rate_hz, text.file, line, "Frame", stream.time);
    for (std::size_t k = 0; k < markers; ++k) {
      Vec3 point = unknown_point();
      for (int axis = 0; axis < 3; ++axis) {
        point[axis] =
            text.number_or_unknown(line, header.markers[k], cells[leading + 3 * k + axis]);
      }
      stream.position(row, k) = metres * point;
    }
  }
}

MarkerRecording read_qualisys_file(const std::filesystem::path& file,
                                   const Conventions& conventions) {
  const files::CsvText text = files::read_table(file);
  if (text.lines.empty()) text.fail(1, "", "the file is empty");
  MarkerRecording recording;
  recording.import_notes = text.notes;
  TsvHeader header = read_tsv_header(text);
  number_repeated_names(header.markers, recording.import_notes);
  const auto included = header.value.find("DATA_INCLUDED");
  if (included != header.value.end() && included->second.second != "3D") {
    text.fail(included->second.first, "DATA_INCLUDED",
              fmt::format("must be 3D, not '{}'; export the markers", included->second.second));
  }
  const double rate_hz = resolve_rate_hz(number_in_header(text, header, "FREQUENCY"), conventions,
                                         text.file, recording.import_notes);
  if (conventions.unit.empty())
    add_note(recording.import_notes, "{} mm, as written by Qualisys", kUnitAssumed);
  recording.unit_m = metres_per_unit(conventions.unit.empty() ? "mm" : conventions.unit, text.file);
  recording.markers.names = header.markers;
  read_frames_of(text, header, recording.unit_m, rate_hz, recording);
  for (const auto& [key, count, noun] :
       {std::tuple("NO_OF_MARKERS", header.markers.size(), "markers"),
        std::tuple("NO_OF_FRAMES", recording.markers.time.size(), "frames")}) {
    const double stated = number_in_header(text, header, key);
    if (stated == 0 || stated == static_cast<double>(count)) continue;
    add_note(recording.import_notes, "the header states {} {}, the file has {}", stated, noun,
             count);
  }
  return recording;
}

}  // namespace

bool recognises_qualisys_tsv(std::string_view head) {
  return files::first_line_with_commas(head).starts_with("NO_OF_FRAMES,") &&
         head.find("\nMARKER_NAMES") != head.npos;
}

Demonstration read_qualisys_tsv(const RecordingFiles& files) {
  return read_marker_recording(files, &read_qualisys_file);
}

}  // namespace morphe::imports
