// Points as text, a row per frame, with any columns (see point_header.hpp for supported headers).
// The time is a column `time` or `t`, or frames and a rate. The file does not contain its axes.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "core/files/table_text.hpp"
#include "stages/import/formats/marker_columns.hpp"
#include "stages/import/formats/marker_recording.hpp"
#include "stages/import/formats/point_header.hpp"
#include "stages/import/formats/readers.hpp"
#include "stages/import/trackers/add_note.hpp"
#include "stages/import/trackers/time_unit.hpp"

namespace morphe::imports {
namespace {

/// The times and frame numbers of the rows, empty if the file does not have them, and their lines.
struct PointRows {
  std::vector<double> time, frame;
  std::vector<std::size_t> line;
};

Vec3 point_in_row(const files::CsvText& text, std::size_t line,
                  const std::vector<std::string_view>& cells, const PointColumns& point) {
  Vec3 result = unknown_point();
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view cell = cells[point.columns[axis]];
    const std::optional<double> value = text.value(cell);
    result[axis] =
        value ? *value
              : text.number_or_unknown(line, fmt::format("{}.{}", point.name, "xyz"[axis]), cell);
  }
  return result;
}

PointRows point_rows(const files::CsvText& text, const PointHeader& header, double metres,
                     MarkerRecording& recording) {
  PointRows rows;
  std::vector<Vec3> values;
  int blank_count = 0;
  for (std::size_t line = header.first_row; line <= text.lines.size(); ++line) {
    std::vector<std::string_view> cells = text.cells(line);
    if (text.is_blank(line)) {
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
      rows.time.push_back(text.number(line, time->name, cells[time->column]));
    if (header.frame) rows.frame.push_back(text.number(line, "frame", cells[*header.frame]));
    for (const PointColumns& point : header.points)
      values.push_back(metres * point_in_row(text, line, cells, point));
  }
  if (rows.line.empty()) text.fail(text.lines.size(), "", "ends before the first row");
  if (blank_count > 0) add_note(recording.import_notes, "{} blank lines skipped", blank_count);
  recording.markers.position = Array2D<Vec3>(rows.line.size(), header.points.size(), Vec3::Zero());
  recording.markers.position.values = std::move(values);
  return rows;
}

void expect_increasing(const files::CsvText& text, const std::vector<double>& values,
                       const PointRows& rows, const std::string& column) {
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (!(values[i] >= values[i - 1]))
      text.fail(rows.line[i], column, "must be greater than in the previous row");
  }
}

void set_times(const files::CsvText& text, const PointHeader& header, const PointRows& rows,
               const Conventions& conventions, MarkerRecording& recording) {
  std::vector<double>& time = recording.markers.time;
  if (header.time && !conventions.rate_hz) {
    expect_increasing(text, rows.time, rows, header.time->name);
    const double seconds = seconds_per_unit(header.time->name, header.time->unit, rows.time,
                                            text.file, recording.import_notes);
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
  const files::CsvText text = files::read_table(file);
  if (text.lines.empty()) text.fail(1, "", "the file is empty");
  const PointHeader header = read_point_header(text);
  if (header.points.empty()) {
    text.fail(1, "",
              "no three columns are x, y and z of a point, such as wrist_x, wrist_y, wrist_z");
  }
  MarkerRecording recording;
  recording.import_notes = text.notes;
  for (const PointColumns& point : header.points) recording.markers.names.push_back(point.name);
  recording.import_notes.insert(recording.import_notes.end(), header.notes.begin(),
                                header.notes.end());
  recording.unit_m =
      resolve_unit_m(header.unit, conventions,
                     fmt::format("{}:{}", text.file, header.first_row - 1), recording.import_notes);
  const PointRows rows = point_rows(text, header, recording.unit_m, recording);
  set_times(text, header, rows, conventions, recording);
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
  // The last line of a head is cut off, unless it is the only one.
  const std::size_t last_end = head.find_last_of("\r\n");
  try {
    return is_table_of_points(
        read_point_header(files::table_from_text("", std::string(head.substr(0, last_end)))));
  } catch (const InputError&) {
    return true;  // the reader reports the error in this header of points
  }
}

Demonstration read_point_csv(const RecordingFiles& files) {
  return read_marker_recording(files, &read_point_file);
}

}  // namespace morphe::imports
