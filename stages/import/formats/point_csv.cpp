// Points as text, a row per frame, with any columns (see point_header.hpp for supported headers),
// separated by commas, semicolons or tabs, with a decimal comma if the file has one. An unseen
// value is an empty cell, NaN, NA, null, none or -. The time is a column `time` or `t`, or frames
// and a rate. The file does not contain its axes.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "stages/import/formats/marker_columns.hpp"
#include "stages/import/formats/marker_recording.hpp"
#include "stages/import/formats/point_header.hpp"
#include "stages/import/formats/readers.hpp"
#include "stages/import/trackers/add_note.hpp"

namespace morphe::imports {
namespace {

/// The times and frame numbers of the rows, empty if the file does not have them, and their lines.
struct PointRows {
  std::vector<double> time, frame;
  std::vector<std::size_t> line;
};

double cell_number(const files::CsvText& text, std::size_t line, const std::string& column,
                   const std::string& cell, const PointHeader& header) {
  const std::optional<double> value = parse_number(cell, header.decimal_comma);
  if (!value) text.fail(line, column, fmt::format("must be a number, not '{}'", cell));
  return *value;
}

Vec3 point_in_row(const files::CsvText& text, std::size_t line,
                  const std::vector<std::string>& cells, const PointColumns& point,
                  const PointHeader& header) {
  Vec3 result = unknown_point();
  for (int axis = 0; axis < 3; ++axis) {
    const std::string& cell = cells[point.columns[axis]];
    if (is_missing_value(cell)) continue;
    result[axis] =
        cell_number(text, line, fmt::format("{}.{}", point.name, "xyz"[axis]), cell, header);
  }
  if (is_partial(result)) text.fail(line, point.name, "has only some of x, y, z");
  return result;
}

PointRows point_rows(const files::CsvText& text, const PointHeader& header, double metres,
                     MarkerRecording& recording) {
  PointRows rows;
  std::vector<Vec3> values;
  int blank_count = 0;
  for (std::size_t line = header.first_row; line <= text.lines.size(); ++line) {
    std::vector<std::string> cells = quoted_cells(text.lines[line - 1], header.separator);
    if (std::ranges::all_of(cells, &std::string::empty)) {
      ++blank_count;
      continue;
    }
    while (cells.size() > header.cells && cells.back().empty()) cells.pop_back();
    if (cells.size() != header.cells) {
      text.fail(
          line, "",
          fmt::format("the row has {} cells, but the header has {}", cells.size(), header.cells));
    }
    rows.line.push_back(line);
    if (const auto& time = header.time)
      rows.time.push_back(cell_number(text, line, time->name, cells[time->column], header));
    if (header.frame)
      rows.frame.push_back(cell_number(text, line, "frame", cells[*header.frame], header));
    for (const PointColumns& point : header.points)
      values.push_back(metres * point_in_row(text, line, cells, point, header));
  }
  if (rows.line.empty()) text.fail(text.lines.size(), "", "ends before the first row");
  if (blank_count > 0) add_note(recording.import_notes, "{} blank lines skipped", blank_count);
  recording.markers.position = Array2D<Vec3>(rows.line.size(), header.points.size(), Vec3::Zero());
  recording.markers.position.values = std::move(values);
  return rows;
}

/// Returns the seconds in one unit of the time column: the header's unit; without it, the first in
/// which the rows have the rate of a camera, which is reported; otherwise 1.
double seconds_of(const TimeColumn& column, const std::vector<double>& time,
                  std::vector<std::string>& reports) {
  constexpr std::pair<const char*, double> kSecondsPer[] = {
      {"s", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}};
  constexpr double kMaxRowPeriod_s = 0.25, kMinRowPeriod_s = 1e-4;
  const double step = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
  for (const auto& [name, seconds] : kSecondsPer) {
    if (column.unit == name) return seconds;
    const bool plausible = step * seconds <= kMaxRowPeriod_s && step * seconds >= kMinRowPeriod_s;
    if (!column.unit.empty() || !plausible) continue;
    add_note(reports, "unit of '{}' not in the file; assumed {}, {:.4g} rows per second",
             column.name, name, 1 / (step * seconds));
    return seconds;
  }
  return 1;
}

void expect_increasing(const files::CsvText& text, const std::vector<double>& values,
                       const PointRows& rows, const std::string& column) {
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (!(values[i] > values[i - 1]))
      text.fail(rows.line[i], column, "must be greater than in the previous row");
  }
}

void set_times(const files::CsvText& text, const PointHeader& header, const PointRows& rows,
               const Conventions& conventions, MarkerRecording& recording) {
  std::vector<double>& time = recording.markers.time;
  if (header.time && !conventions.rate_hz) {
    expect_increasing(text, rows.time, rows, header.time->name);
    const double seconds =
        rows.time.size() > 1 ? seconds_of(*header.time, rows.time, recording.import_notes) : 1;
    constexpr double kMaxStartTime_s = 1e5;  // more than a day: the times are absolute
    const double begin = rows.time[0] * seconds > kMaxStartTime_s ? rows.time[0] : 0;
    if (begin > 0) recording.import_notes.push_back("times are counted from that of the first row");
    for (const double value : rows.time) time.push_back((value - begin) * seconds);
    return;
  }
  const double rate_hz = resolve_rate_hz(0, conventions, text.file, recording.import_notes);
  if (header.frame) expect_increasing(text, rows.frame, rows, "frame");
  for (std::size_t i = 0; i < rows.line.size(); ++i) {
    time.push_back((header.frame ? rows.frame[i] - rows.frame[0] : static_cast<double>(i)) /
                   rate_hz);
  }
}

MarkerRecording read_point_file(const std::filesystem::path& file, const Conventions& conventions) {
  const files::CsvText text = files::read_csv(file);
  if (text.lines.empty()) text.fail(1, "", "the file is empty");
  const PointHeader header = read_point_header(text);
  if (header.points.empty()) {
    text.fail(1, "",
              "no three columns are x, y and z of a point, such as wrist_x, wrist_y, wrist_z");
  }
  MarkerRecording recording;
  recording.import_notes = text.notes;
  for (const PointColumns& point : header.points) recording.markers.names.push_back(point.name);
  const double metres =
      resolve_unit_m(header.unit, conventions,
                     fmt::format("{}:{}", text.file, header.first_row - 1), recording.import_notes);
  const PointRows rows = point_rows(text, header, metres, recording);
  set_times(text, header, rows, conventions, recording);
  if (header.decimal_comma) recording.import_notes.push_back("numbers use decimal commas");
  if (header.lines_before > 0)
    add_note(recording.import_notes, "{} lines before the header skipped", header.lines_before);
  if (!header.ignored_columns.empty()) {
    add_note(recording.import_notes, "columns skipped, not points: {}",
             fmt::join(header.ignored_columns, ", "));
  }
  return recording;
}

/// Returns true if the table is one of points. Other tables may have three columns that resemble a
/// point, such as the angles of a shoulder blade called Scap_X, Scap_Y, Scap_Z.
bool is_table_of_points(const PointHeader& header) {
  constexpr std::size_t kMaxOtherColumns = 4;  // the columns of a rotation
  return header.points.size() > 1 ||
         (header.points.size() == 1 && header.ignored_columns.size() <= kMaxOtherColumns);
}

}  // namespace

bool recognises_point_csv(std::string_view head) {
  if (head.find('\0') != head.npos || head.starts_with("Format Version")) return false;
  // Exclude tables beside a recording of hands, with trajectories of a headset and objects.
  for (const char* first : {"graph_uid,", "session_uid,", "object_uid,"}) {
    if (head.starts_with(first)) return false;
  }
  files::CsvText text;
  while (!head.empty()) {
    const std::size_t end = head.find_first_of("\r\n");
    if (end == head.npos && !text.lines.empty()) break;  // the line continues beyond the head
    text.lines.emplace_back(head.substr(0, end));
    head.remove_prefix(end == head.npos ? head.size() : end + 1);
    if (text.lines.back().empty()) text.lines.pop_back();
  }
  try {
    return is_table_of_points(read_point_header(text));
  } catch (const InputError&) {
    return true;  // the reader reports the error in this header of points
  }
}

Demonstration read_point_csv(const RecordingFiles& files) {
  return read_marker_recording(files, &read_point_file);
}

}  // namespace morphe::imports
