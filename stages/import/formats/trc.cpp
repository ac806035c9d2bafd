// TRC, as written by Motion Analysis and OpenSim, separated by tabs or commas: line 1
// "PathFileType" and its original path, 2 names of the header's values, 3 the values, 4 "Frame#",
// "Time" and a marker's name in every third column, 5 "X1 Y1 Z1 …", then a row per frame, often
// after a blank line. The numbers of frames and markers in the header are only compared with the
// contents. An empty cell or NaN means not seen. The file does not contain its axes.
#include <fmt/format.h>

#include <cmath>
#include <map>

#include "stages/import/formats/marker_columns.hpp"
#include "stages/import/formats/marker_recording.hpp"
#include "stages/import/formats/readers.hpp"
#include "stages/import/trackers/add_note.hpp"
#include "stages/import/trackers/hand_tracker.hpp"

namespace morphe::imports {
namespace {

constexpr std::size_t kKeyLine = 2, kValueLine = 3, kNameLine = 4, kAxisLine = 5, kFirstRow = 6;

using TrcHeader = std::map<std::string, std::string, std::less<>>;

TrcHeader read_trc_header(const files::CsvText& csv) {
  TrcHeader header;
  const auto keys = csv.cells(kKeyLine), values = csv.cells(kValueLine);
  for (std::size_t c = 0; c < keys.size(); ++c) {
    if (keys[c].empty()) continue;
    const std::string_view value = c < values.size() ? values[c] : std::string_view();
    if (!header.emplace(keys[c], value).second) csv.fail(kKeyLine, keys[c], "appears twice");
  }
  return header;
}

std::string value_of(const TrcHeader& header, std::string_view key) {
  const auto found = header.find(key);
  return found == header.end() ? "" : found->second;
}

void compare_count(const files::CsvText& csv, const TrcHeader& header, std::string_view key,
                   std::string_view noun, std::size_t count, std::vector<std::string>& reports) {
  const std::string value = value_of(header, key);
  if (value.empty() || csv.number(kValueLine, key, value) == static_cast<double>(count)) return;
  add_note(reports, "the header states {} {}, the file has {}", value, noun, count);
}

void check_axes(const files::CsvText& csv, const MarkerColumns& columns) {
  const auto cells = csv.cells(kAxisLine);
  for (std::size_t c = MarkerColumns::kLeadingCount; c < columns.count(); ++c) {
    const std::size_t k = c - MarkerColumns::kLeadingCount;
    const std::string label = fmt::format("{}{}", "XYZ"[k % 3], k / 3 + 1);
    if (c >= cells.size() || cells[c] != label)
      csv.fail(kAxisLine, columns.name(c), fmt::format("must be under '{}'", label));
  }
}

/// Reads the rows from the sixth line on, with the file's times, which are compared to `rate_hz`.
void read_rows(const files::CsvText& csv, const MarkerColumns& columns, double metres,
               double rate_hz, MarkerRecording& recording) {
  MarkerStream& markers = recording.markers;
  const std::size_t first = csv.is_blank(kFirstRow) ? kFirstRow + 1 : kFirstRow;
  markers.position = {csv.lines.size() - first + 1, columns.names.size(), unknown_point()};
  for (std::size_t line = first; line <= csv.lines.size(); ++line) {
    const auto cells = csv.cells(line);
    read_points(csv, line, cells, columns, metres, markers.position, line - first);
    csv.number(line, "Frame#", cells[0]);
    add_time(csv.number(line, "Time", cells[1]), csv.file, line, "Time", markers.time);
  }
  const double steps = static_cast<double>(markers.time.size() - 1);
  const double rows_hz = steps / (markers.time.back() - markers.time.front());
  if (steps > 0 && rate_hz > 0 && std::abs(rows_hz - rate_hz) > 0.01 * rate_hz) {
    add_note(recording.import_notes,
             "the header states {} frames per second, the times give {:.6g}; the times are used",
             rate_hz, rows_hz);
  }
}

MarkerRecording read_trc_file(const std::filesystem::path& file, const Conventions& conventions) {
  files::CsvText csv = files::read_csv(file);
  if (csv.lines.size() < kFirstRow) csv.fail(csv.lines.size(), "", "ends before the first frame");
  csv.separator = csv.lines[0].find('\t') != std::string::npos ? '\t' : ',';
  if (csv.cells(1)[0] != "PathFileType") csv.fail(1, "", "must begin with 'PathFileType'");
  MarkerRecording recording;
  recording.import_notes = csv.notes;
  const auto leading = csv.cells(kNameLine);
  if (leading.size() < 3 || leading[0] != "Frame#" || leading[1] != "Time")
    csv.fail(kNameLine, "", "must begin with 'Frame#' and 'Time'");
  const TrcHeader header = read_trc_header(csv);
  const MarkerColumns columns{{"Frame#", "Time"}, read_marker_names(csv, kNameLine)};
  check_axes(csv, columns);
  const double metres =
      resolve_unit_m(value_of(header, "Units"), conventions,
                     fmt::format("{}:{}", csv.file, kValueLine), recording.import_notes);
  const std::string rate = value_of(header, "DataRate");
  const double in_file = rate.empty() ? 0 : csv.number(kValueLine, "DataRate", rate);
  const double rate_hz = conventions.rate_hz.value_or(in_file);
  recording.markers.names = columns.names;
  read_rows(csv, columns, metres, rate_hz, recording);
  compare_count(csv, header, "NumMarkers", "markers", columns.names.size(), recording.import_notes);
  compare_count(csv, header, "NumFrames", "frames", recording.markers.time.size(),
                recording.import_notes);
  return recording;
}

}  // namespace

bool recognises_trc(std::string_view head) { return head.starts_with("PathFileType"); }

Demonstration read_trc(const RecordingFiles& files) {
  return read_marker_recording(files, &read_trc_file);
}

}  // namespace morphe::imports
