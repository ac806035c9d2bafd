// TRC, as written by Motion Analysis, OpenSim and many scripts, separated by tabs, commas or
// blanks: "PathFileType" and its original path, a line of keys and one of values, "Frame#", "Time"
// and the markers' names, each above its X, a redundant line "X1 Y1 Z1 …" that may be absent or say
// "X Y Z", then a row per frame. Blank lines may stand anywhere. The numbers of frames and markers
// in the header are only compared with the contents. The file does not contain its axes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <span>

#include "core/files/table_text.hpp"
#include "stages/import/formats/marker_columns.hpp"
#include "stages/import/formats/marker_recording.hpp"
#include "stages/import/formats/readers.hpp"
#include "stages/import/recording/column_label.hpp"
#include "stages/import/recording/repeated_names.hpp"
#include "stages/import/trackers/add_note.hpp"
#include "stages/import/trackers/hand_tracker.hpp"

namespace morphe::imports {
namespace {

using TrcHeader = std::map<std::string, std::string, std::less<>>;  // by key in lower case

/// The lines of a file, from 1.
struct TrcLines {
  std::size_t keys = 0, values = 0, names = 0;
  std::size_t axes = 0;  ///< 0 if absent
  std::vector<std::size_t> rows;
};

std::size_t next_line(const files::CsvText& csv, std::size_t line) {
  line = csv.filled_line(line + 1);
  if (line > csv.lines.size()) csv.fail(csv.lines.size(), "", "ends before the first frame");
  return line;
}

TrcLines find_lines(const files::CsvText& csv) {
  TrcLines lines;
  lines.keys = next_line(csv, next_line(csv, 0));
  lines.values = next_line(csv, lines.keys);
  lines.names = next_line(csv, lines.values);
  std::size_t line = next_line(csv, lines.names);
  if (!csv.value(csv.cells(line)[0])) {
    lines.axes = line;
    line = next_line(csv, line);
  }
  for (; line <= csv.lines.size(); ++line) {
    if (!csv.is_blank(line)) lines.rows.push_back(line);
  }
  return lines;
}

TrcHeader read_trc_header(const files::CsvText& csv, const TrcLines& lines) {
  TrcHeader header;
  const auto keys = csv.cells(lines.keys), values = csv.cells(lines.values);
  for (std::size_t c = 0; c < keys.size(); ++c) {
    if (keys[c].empty()) continue;
    const std::string_view value = c < values.size() ? values[c] : std::string_view();
    if (!header.emplace(to_lower(keys[c]), value).second)
      csv.fail(lines.keys, keys[c], "appears twice");
  }
  return header;
}

std::string value_of(const TrcHeader& header, std::string_view key) {
  const auto found = header.find(to_lower(key));
  return found == header.end() ? "" : found->second;
}

void compare_count(const files::CsvText& csv, const TrcHeader& header, std::string_view key,
                   std::string_view noun, std::size_t count, std::vector<std::string>& reports) {
  const std::string value = value_of(header, key);
  const std::optional<double> stated = csv.value(value);
  if (!stated || *stated == static_cast<double>(count)) return;
  add_note(reports, "the header states {} {}, the file has {}", value, noun, count);
}

/// Returns one of each three names if these differ in a final X, Y, Z only; else all of them.
std::vector<std::string> one_of_three(const std::vector<std::string>& names) {
  std::vector<std::string> first;
  for (std::size_t k = 0; k + 2 < names.size(); k += 3) {
    std::string stem = names[k];
    for (std::size_t axis = 1; axis < 3; ++axis) {
      if (names[k + axis] != names[k]) stem = names[k].substr(0, names[k].size() - 1);
      if (names[k + axis] != names[k] && names[k + axis] != stem + "XYZ"[axis]) return names;
    }
    first.push_back(stem == names[k] ? stem : trim(stem, " _.:-"));
  }
  return names.size() % 3 == 0 ? first : names;
}

/// Returns the markers' names. Some programs write them one beside the other, or above each of X, Y
/// and Z: with three columns each, they are as many as the first row has after its number and time.
std::vector<std::string> read_names(const files::CsvText& csv, const TrcLines& lines,
                                    std::vector<std::string>& notes) {
  constexpr std::size_t kLeading = 2;
  const auto cells = csv.cells(lines.names), row = csv.cells(lines.rows[0]);
  if (cells.size() <= kLeading || !to_lower(cells[0]).starts_with("frame") ||
      !to_lower(cells[1]).starts_with("time")) {
    csv.fail(lines.names, "", "must begin with 'Frame#' and 'Time'");
  }
  std::vector<std::string> names;
  for (const std::string_view cell : std::span(cells).subspan(kLeading)) {
    if (!cell.empty()) names.emplace_back(cell);
  }
  if (kLeading + names.size() == row.size()) names = one_of_three(names);
  const bool adjacent = cells.size() > kLeading + 1 && !cells[kLeading + 1].empty();
  if (!adjacent || kLeading + 3 * names.size() != row.size())
    return read_marker_names(csv, lines.names, kLeading, notes);
  number_repeated_names(names, notes);
  return names;
}

/// Checks the letters of labels such as "X1", "x" or "Z 12"; other labels are not looked at.
void check_axes(const files::CsvText& csv, const TrcLines& lines, const MarkerColumns& columns) {
  if (lines.axes == 0) return;
  const auto cells = csv.cells(lines.axes);
  const std::size_t leading = columns.leading.size();
  const std::size_t begin = cells[0].empty() ? leading : 0;  // between blanks, no cell is empty
  for (std::size_t k = 0; k < 3 * columns.names.size() && begin + k < cells.size(); ++k) {
    const std::string letter = to_lower(trim(cells[begin + k], " 0123456789_#"));
    if (letter.size() != 1 || letter[0] < 'x' || letter[0] > 'z' || letter[0] == "xyz"[k % 3])
      continue;
    csv.fail(lines.axes, columns.name(leading + k),
             fmt::format("must be under '{}{}'", "XYZ"[k % 3], k / 3 + 1));
  }
}

/// Reads the rows with the file's times, or, if the rate is given, with those of the frame numbers.
void read_rows(const files::CsvText& csv, const TrcLines& lines, const MarkerColumns& columns,
               double metres, std::optional<double> given_hz, MarkerRecording& recording) {
  MarkerStream& markers = recording.markers;
  markers.position = {lines.rows.size(), columns.names.size(), unknown_point()};
  double first_frame = 0;
  for (std::size_t row = 0; row < lines.rows.size(); ++row) {
    const std::size_t line = lines.rows[row];
    const auto cells = csv.cells(line);
    if (cells.size() < columns.leading.size()) csv.fail(line, "Time", "the cell is missing");
    read_points(csv, line, cells, columns, metres, markers.position, row);
    const double frame = csv.number(line, "Frame#", cells[0]);
    if (row == 0) first_frame = frame;
    const double time_s =
        given_hz ? (frame - first_frame) / *given_hz : csv.number(line, "Time", cells[1]);
    add_time(time_s, csv.file, line, given_hz ? "Frame#" : "Time", markers.time);
  }
}

void compare_rate(double in_file_hz, MarkerRecording& recording) {
  const std::vector<double>& time = recording.markers.time;
  const double rows_hz = static_cast<double>(time.size() - 1) / (time.back() - time.front());
  if (time.size() < 2 || !(in_file_hz > 0) || std::abs(rows_hz - in_file_hz) <= 0.01 * in_file_hz)
    return;
  add_note(recording.import_notes,
           "the header states {} frames per second, the times give {:.6g}; the times are used",
           in_file_hz, rows_hz);
}

MarkerRecording read_trc_file(const std::filesystem::path& file, const Conventions& conventions) {
  const files::CsvText csv = files::read_table(file);
  if (csv.lines.empty()) csv.fail(1, "", "ends before the first frame");
  const TrcLines lines = find_lines(csv);
  MarkerRecording recording;
  recording.import_notes = csv.notes;
  const TrcHeader header = read_trc_header(csv, lines);
  const MarkerColumns columns{{"Frame#", "Time"}, read_names(csv, lines, recording.import_notes)};
  check_axes(csv, lines, columns);
  recording.unit_m =
      resolve_unit_m(value_of(header, "Units"), conventions,
                     fmt::format("{}:{}", csv.file, lines.values), recording.import_notes);
  recording.markers.names = columns.names;
  read_rows(csv, lines, columns, recording.unit_m, conventions.rate_hz, recording);
  const double in_file_hz = csv.value(value_of(header, "DataRate")).value_or(0);
  if (conventions.rate_hz) {
    resolve_rate_hz(in_file_hz, conventions, csv.file, recording.import_notes);
  } else {
    compare_rate(in_file_hz, recording);
  }
  compare_count(csv, header, "NumMarkers", "markers", columns.names.size(), recording.import_notes);
  compare_count(csv, header, "NumFrames", "frames", recording.markers.time.size(),
                recording.import_notes);
  return recording;
}

}  // namespace

bool recognises_trc(std::string_view head) {
  return to_lower(files::first_line_with_commas(head)).starts_with("pathfiletype");
}

Demonstration read_trc(const RecordingFiles& files) {
  return read_marker_recording(files, &read_trc_file);
}

}  // namespace morphe::imports
