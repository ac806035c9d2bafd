// Vicon "Trajectories" export: line 1 "Trajectories", 2 rate [Hz], 3 marker names in every third
// column from the third ("SUBJECT:NAME"), 4 "Frame,Sub Frame,X,Y,Z,…", 5 units, then a row a frame;
// an empty cell is a marker that was not seen. The laboratory frame of such a recording must
// already be X right, Y forward, Z up.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <set>

#include "stages/import/csv.hpp"
#include "stages/import/format.hpp"

namespace morphe {
namespace {

constexpr std::size_t kFirstMarkerColumn = 2;  // after Frame and Sub Frame
constexpr char kAxis[] = {'X', 'Y', 'Z'};

struct Header {
  double rate_hz = 0;
  double metres = 1;               ///< per unit of the file
  std::vector<std::string> names;  ///< without the subject
  std::string subject;
  std::size_t columns() const { return kFirstMarkerColumn + 3 * names.size(); }
  std::string column(std::size_t index) const {
    if (index < kFirstMarkerColumn) return index == 0 ? "Frame" : "Sub Frame";
    return fmt::format("{}.{}", names[(index - kFirstMarkerColumn) / 3],
                       kAxis[(index - kFirstMarkerColumn) % 3]);
  }
};

std::string_view cell_at(const std::vector<std::string_view>& cells, std::size_t column) {
  return column < cells.size() ? cells[column] : std::string_view();
}

void read_names(const CsvText& csv, Header& header) {
  const auto cells = csv.cells(3);
  std::size_t last = 0;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (!cells[c].empty()) last = c;
  }
  std::set<std::string> known;
  for (std::size_t c = 0; c <= last; ++c) {
    const std::string_view cell = cells[c];
    const bool names_marker = c >= kFirstMarkerColumn && (c - kFirstMarkerColumn) % 3 == 0;
    if (names_marker && cell.empty()) {
      csv.fail(3, fmt::format("column {}", c + 1), "has no marker name");
    }
    if (!names_marker && !cell.empty()) {
      csv.fail(3, fmt::format("column {}", c + 1),
               fmt::format("'{}' stands where no marker begins", cell));
    }
    if (!names_marker) continue;
    const std::size_t colon = cell.find(':');
    std::string name(colon == std::string_view::npos ? cell : cell.substr(colon + 1));
    if (name.empty()) csv.fail(3, cell, "has no name after the subject");
    if (colon != std::string_view::npos && header.subject.empty()) {
      header.subject = cell.substr(0, colon);
    }
    if (!known.insert(name).second) csv.fail(3, name, "the marker stands twice");
    header.names.push_back(std::move(name));
  }
  if (header.names.empty()) csv.fail(3, "", "names no marker");
}

void check_axes_and_unit(const CsvText& csv, Header& header) {
  const auto axes = csv.cells(4), units = csv.cells(5);
  if (cell_at(axes, 0) != "Frame") csv.fail(4, "Frame", "the column is missing");
  if (cell_at(axes, 1) != "Sub Frame") csv.fail(4, "Sub Frame", "the column is missing");
  std::string_view unit;
  for (std::size_t c = kFirstMarkerColumn; c < header.columns(); ++c) {
    const std::string_view axis(&kAxis[(c - kFirstMarkerColumn) % 3], 1);
    if (cell_at(axes, c) != axis) csv.fail(4, header.column(c), "the column is missing");
    const std::string_view here = cell_at(units, c);
    if (here != "mm" && here != "m") {
      csv.fail(5, header.column(c), fmt::format("unit must be mm or m, not '{}'", here));
    }
    if (unit.empty()) unit = here;
    if (here != unit) csv.fail(5, header.column(c), "unit differs from the first column's");
  }
  for (const auto& [line, cells] : {std::pair(4, &axes), std::pair(5, &units)}) {
    for (std::size_t c = header.columns(); c < cells->size(); ++c) {
      if (!(*cells)[c].empty()) {
        csv.fail(static_cast<std::size_t>(line), fmt::format("column {}", c + 1),
                 "belongs to no marker of line 3");
      }
    }
  }
  header.metres = unit == "mm" ? 1e-3 : 1;
}

Header read_header(const CsvText& csv) {
  if (csv.lines.empty() || cell_at(csv.cells(1), 0) != "Trajectories") {
    csv.fail(1, "", "must be 'Trajectories'");
  }
  if (csv.lines.size() < 6) csv.fail(csv.lines.size(), "", "ends before the first frame");
  Header header;
  header.rate_hz = csv.number(2, "rate", csv.cells(2)[0]);
  if (header.rate_hz <= 0) csv.fail(2, "rate", "must be positive");
  read_names(csv, header);
  check_axes_and_unit(csv, header);
  return header;
}

/// One frame: its number, and the points into row `row`.
double read_frame(const CsvText& csv, std::size_t line, const Header& header, std::size_t row,
                  Table<Vec3>& position) {
  const auto cells = csv.cells(line);
  if (cells.size() < header.columns()) {
    csv.fail(line, header.column(cells.size()),
             fmt::format("the row has {} cells, the header {}", cells.size(), header.columns()));
  }
  for (std::size_t c = header.columns(); c < cells.size(); ++c) {
    if (!cells[c].empty()) {
      csv.fail(line, fmt::format("column {}", c + 1),
               fmt::format("the row has {} cells, the header {}", cells.size(), header.columns()));
    }
  }
  for (std::size_t k = 0; k < header.names.size(); ++k) {
    Vec3& point = position(row, k);
    int filled = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t c = kFirstMarkerColumn + 3 * k + axis;
      if (cells[c].empty()) continue;
      point[static_cast<Eigen::Index>(axis)] =
          csv.number(line, header.column(c), cells[c]) * header.metres;
      ++filled;
    }
    if (filled != 0 && filled != 3) {
      csv.fail(line, header.names[k], "has some of X, Y, Z but not all");
    }
  }
  if (csv.number(line, "Sub Frame", cells[1]) != 0) {
    csv.fail(line, "Sub Frame", "must be 0: no sub-frame data is read");
  }
  return csv.number(line, "Frame", cells[0]);
}

MarkerStream read_trajectories(const CsvText& csv, const Header& header) {
  MarkerStream markers;
  markers.names = header.names;
  const std::size_t frames = csv.lines.size() - 5;
  markers.position = Table<Vec3>(frames, header.names.size(), unseen_point());
  for (std::size_t i = 0; i < frames; ++i) {
    const std::size_t line = i + 6;
    const double frame = read_frame(csv, line, header, i, markers.position);
    if (frame != std::floor(frame) || frame < 1) {
      csv.fail(line, "Frame", "must be a whole number from 1");
    }
    markers.time.push_back((frame - 1) / header.rate_hz);
    if (i > 0 && markers.time[i] <= markers.time[i - 1]) {
      csv.fail(line, "Frame", "does not follow the frame before");
    }
  }
  return markers;
}

std::set<std::string> rename(const CsvText& csv, const std::map<std::string, std::string>& renamed,
                             MarkerStream& markers) {
  std::set<std::string> used, known;
  for (std::string& name : markers.names) {
    if (const auto entry = renamed.find(name); entry != renamed.end()) {
      used.insert(name);
      name = entry->second;
    }
    if (!known.insert(name).second) csv.fail(3, name, "two markers are renamed to this");
  }
  return used;
}

}  // namespace

bool recognises_vicon_csv(std::string_view head) {
  const std::string_view line = head.substr(0, head.find_first_of("\r\n,"));
  return line == "Trajectories";
}

Demonstration read_vicon_csv(const RecordingFiles& files) {
  const CsvText csv = read_csv(files.file);
  const Header header = read_header(csv);
  Demonstration demonstration;
  demonstration.subject = header.subject;
  demonstration.streams.markers = read_trajectories(csv, header);
  std::set<std::string> used = rename(csv, files.renamed, *demonstration.streams.markers);
  if (!files.static_trial.empty()) {
    const CsvText trial = read_csv(files.static_trial);
    demonstration.calibration.markers = read_trajectories(trial, read_header(trial));
    used.merge(rename(trial, files.renamed, *demonstration.calibration.markers));
  }
  for (const auto& entry : files.renamed) {
    if (!used.contains(entry.first)) {
      csv.fail(3, entry.first, "is renamed but no such marker was recorded");
    }
  }
  return demonstration;
}

}  // namespace morphe
