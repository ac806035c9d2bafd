// Vicon's export: sections with blank lines between them, each with a line for its name, the rate
// [Hz], names, columns, units and a row per frame. The section "Trajectories" names a marker in
// every third column ("SUBJECT:NAME") over "Frame,Sub Frame,X,Y,Z,…" (Nexus) or "Field #,X,Y,Z,…"
// (Workstation, whose rate is "120,Hz"). The axes are not in the file; X right, Y forward, Z up are
// usual.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/files/table_text.hpp"
#include "stages/import/formats/marker_columns.hpp"
#include "stages/import/formats/marker_recording.hpp"
#include "stages/import/formats/readers.hpp"
#include "stages/import/recording/column_label.hpp"
#include "stages/import/trackers/add_note.hpp"

namespace morphe::imports {
namespace {

constexpr std::string_view kMarkerSection = "Trajectories";
constexpr std::string_view kOtherSections[] = {"Devices", "Joints", "Segments",  "Model Outputs",
                                               "Events",  "Analog", "Gaitcycles"};
constexpr std::string_view kFrameLabels[] = {"frame", "field #", "field#", "field", "sample #"};

std::string_view cell_at(const std::vector<std::string_view>& cells, std::size_t column) {
  return column < cells.size() ? cells[column] : std::string_view();
}

bool is_section(std::string_view text, std::string_view name) {
  return to_lower(text) == to_lower(name);
}

bool is_other_section(std::string_view text) {
  return std::ranges::any_of(kOtherSections,
                             [&](std::string_view name) { return is_section(text, name); });
}

/// The section of markers: the line of its name and the line of its last frame.
struct Section {
  std::size_t first = 0, last = 0;
};

Section find_section(const files::CsvText& csv, std::vector<std::string>& reports) {
  Section markers;
  std::vector<std::string> others;
  for (std::size_t line = 1; line <= csv.lines.size(); ++line) {
    if (csv.is_blank(line)) continue;
    const std::size_t first = line;
    while (line < csv.lines.size() && !csv.is_blank(line + 1)) ++line;
    const std::string name(csv.cells(first)[0]);
    if (is_section(name, kMarkerSection)) {
      if (markers.first != 0) csv.fail(first, name, "the section appears twice");
      markers = {first, line};
    } else if (is_other_section(name)) {
      others.push_back(name);
    } else {
      csv.fail(first, "",
               fmt::format("a section must begin here, but '{}' is not a section", name));
    }
  }
  if (markers.first == 0) csv.fail(1, "", "section 'Trajectories' not found");
  if (markers.last < markers.first + 5) csv.fail(markers.last, "", "ends before the first frame");
  if (!others.empty()) add_note(reports, "sections skipped: {}", fmt::join(others, ", "));
  return markers;
}

/// Replaces "SUBJECT:NAME" by NAME if there is one subject, and the names stay different.
void strip_subject(std::vector<std::string>& names, std::string& subject,
                   std::vector<std::string>& reports) {
  std::set<std::string> subjects, stripped;
  for (const std::string& name : names) {
    const std::size_t colon = name.find(':');
    if (colon != std::string::npos) subjects.insert(name.substr(0, colon));
    stripped.insert(colon == std::string::npos ? name : name.substr(colon + 1));
  }
  if (subjects.empty()) return;
  if (subjects.size() > 1 || stripped.size() < names.size()) {
    add_note(reports, "marker names keep the subject as prefix: {}", fmt::join(subjects, ", "));
    return;
  }
  subject = *subjects.begin();
  for (std::string& name : names) name.erase(0, name.find(':') + 1);
}

/// Returns the rate in the first cell of a line, "100" or "120 Hz"; 0 if it is empty.
double rate_in(const files::CsvText& csv, std::size_t line) {
  const std::string_view cell = csv.cells(line)[0];
  const std::string_view number = cell.substr(0, cell.find_first_of(" hH"));
  return number.empty() ? 0 : csv.number(line, "rate", number);
}

/// Returns the names of the columns left of the first marker's, in the line of the axes.
std::vector<std::string> leading_columns(const files::CsvText& csv, std::size_t names_line) {
  const auto names = csv.cells(names_line), labels = csv.cells(names_line + 1);
  const std::string first = to_lower(labels[0]);
  const bool is_frame = std::ranges::find(kFrameLabels, first) != std::end(kFrameLabels);
  const bool one_column = !names[0].empty() || (names.size() > 1 && !names[1].empty());
  if (is_frame && one_column && names[0].empty()) return {std::string(labels[0])};
  return {"Frame", "Sub Frame"};
}

/// Checks the axes in a line and the units below; returns the unit of all columns, "" if absent.
std::string read_columns_and_unit(const files::CsvText& csv, std::size_t line,
                                  const MarkerColumns& columns) {
  const auto axes = csv.cells(line), units = csv.cells(line + 1);
  for (std::size_t c = 0; c < columns.count(); ++c) {
    const std::string name = columns.name(c);
    const std::string label = c < columns.leading.size() ? name : name.substr(name.size() - 1);
    if (cell_at(axes, c) != label) csv.fail(line, name, "the column is missing");
  }
  const std::string_view unit = cell_at(units, columns.leading.size());
  for (std::size_t c = columns.leading.size(); c < columns.count(); ++c) {
    if (cell_at(units, c) == unit) continue;
    csv.fail(line + 1, columns.name(c), "has another unit than the first column");
  }
  for (const auto& [cells_line, cells] : {std::pair(line, &axes), std::pair(line + 1, &units)}) {
    for (std::size_t c = columns.count(); c < cells->size(); ++c) {
      if ((*cells)[c].empty()) continue;
      csv.fail(cells_line, fmt::format("column {}", c + 1), "belongs to no marker");
    }
  }
  return std::string(unit);
}

/// Reads the frames in the lines from `line` to `last`, and reports missing frame numbers.
void read_frames(const files::CsvText& csv, std::size_t line, std::size_t last,
                 const MarkerColumns& columns, double metres, double rate_hz,
                 MarkerRecording& recording) {
  MarkerStream& markers = recording.markers;
  markers.position = Array2D<Vec3>(last - line + 1, columns.names.size(), unknown_point());
  double previous_frame = 0, missing = 0;
  for (std::size_t row = 0; line <= last; ++line, ++row) {
    const auto cells = csv.cells(line);
    read_points(csv, line, cells, columns, metres, markers.position, row);
    const double frame = csv.number(line, "Frame", cells[0]);
    if (columns.leading.size() > 1 && csv.number(line, "Sub Frame", cells[1]) != 0)
      csv.fail(line, "Sub Frame", "must be 0; sub-frames are not supported");
    if (frame != std::floor(frame) || frame < 1)
      csv.fail(line, "Frame", "must be a whole number, at least 1");
    if (frame < previous_frame) csv.fail(line, "Frame", "must be greater than in the previous row");
    if (row > 0 && frame > previous_frame) missing += frame - previous_frame - 1;
    previous_frame = frame;
    markers.time.push_back((frame - 1) / rate_hz);
  }
  if (missing > 0) add_note(recording.import_notes, "{} frame numbers are missing", missing);
}

MarkerRecording read_vicon_file(const std::filesystem::path& file, const Conventions& conventions) {
  const files::CsvText csv = files::read_table(file);
  MarkerRecording recording;
  recording.import_notes = csv.notes;
  const Section section = find_section(csv, recording.import_notes);
  const std::size_t line = section.first;
  const double rate_hz =
      resolve_rate_hz(rate_in(csv, line + 1), conventions, fmt::format("{}:{}", csv.file, line + 1),
                      recording.import_notes);
  MarkerColumns columns{leading_columns(csv, line + 2), {}};
  columns.names = read_marker_names(csv, line + 2, columns.leading.size(), recording.import_notes);
  strip_subject(columns.names, recording.subject, recording.import_notes);
  const std::string unit = read_columns_and_unit(csv, line + 3, columns);
  recording.unit_m = resolve_unit_m(unit, conventions, fmt::format("{}:{}", csv.file, line + 4),
                                    recording.import_notes);
  recording.markers.names = columns.names;
  read_frames(csv, line + 5, section.last, columns, recording.unit_m, rate_hz, recording);
  return recording;
}

}  // namespace

bool recognises_vicon_csv(std::string_view head) {
  const std::string line = files::first_line_with_commas(head);
  const std::string name = line.substr(0, line.find(','));
  return is_section(name, kMarkerSection) || is_other_section(name);
}

Demonstration read_vicon_csv(const RecordingFiles& files) {
  return read_marker_recording(files, &read_vicon_file, "x y z");
}

}  // namespace morphe::imports
